/// Content of model files that Assimp ignores without a word, found in their text.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rtcore {

/// Material libraries of a Wavefront file (.obj) that Assimp does not find: neither as they are named nor
/// beside the model under its own name with .mtl. Nothing when the file is no .obj.
std::vector<std::string> missingMaterialLibraries(const std::filesystem::path& path);

/// The libraries that it does find, in the order in which the file names them.
std::vector<std::filesystem::path> materialLibraries(const std::filesystem::path& path);

/// Forms of what is to be said of a Collada file (.dae): textures that do not repeat, orthographic cameras.
/// Nothing when the file is no .dae.
std::vector<const char*> unreadInCollada(const std::filesystem::path& path);

} // namespace rtcore
