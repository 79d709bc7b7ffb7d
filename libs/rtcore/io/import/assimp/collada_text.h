/// Collada files in the words that Assimp understands.
#pragma once

#include "rtcore/io/import/assimp/collada_morphs.h"

#include <filesystem>
#include <optional>
#include <string>

namespace rtcore {

/// The text of a .dae file without morph controllers (by colladaWithoutMorphs()) and without blanks before
/// the numbers of colours, where Assimp stops, and of joints of skins, where it counts without end; channels
/// of animations that name no transform of a node, at which it fails, name nothing. Nothing where the file is
/// no .dae or has none of these. Throws as openFileBytes() does.
std::optional<std::string> colladaForAssimp(const std::filesystem::path& path,
                                            const ColladaWeights& weights = {});

} // namespace rtcore
