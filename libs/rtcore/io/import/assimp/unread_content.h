/// Content of model files that Assimp ignores without a word, found in their text.
#pragma once

#include <filesystem>
#include <vector>

namespace rtcore {

/// Forms of what is to be said of a Collada file (.dae): textures that do not repeat, orthographic cameras.
/// Nothing when the file is no .dae.
std::vector<const char*> unreadInCollada(const std::filesystem::path& path);

} // namespace rtcore
