/// Collada files in the words that Assimp understands.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace rtcore {

/// The text of a .dae file without morph controllers (collada_morphs.h) and without blanks before the numbers
/// of colours, where Assimp stops, and of joints of skins, where it counts without end. Nothing where the
/// file is no .dae or has neither. Throws as openFileBytes() does.
std::optional<std::string> colladaForAssimp(const std::filesystem::path& path);

} // namespace rtcore
