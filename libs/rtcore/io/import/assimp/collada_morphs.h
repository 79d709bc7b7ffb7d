/// Morph targets of Collada files, at whose controllers Assimp fails.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace rtcore {

/// The text of a .dae of which the morph controllers are gone: where they stood stand their geometries, moved
/// as far as the weights say. Of several controllers of one geometry the first counts, and normals are moved
/// where targets have as many. Nothing where the file is no .dae or has no such controller.
/// Throws as openFileBytes() does.
std::optional<std::string> colladaWithoutMorphs(const std::filesystem::path& path);

} // namespace rtcore
