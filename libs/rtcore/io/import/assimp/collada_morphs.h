/// Morph targets of Collada files, at whose controllers Assimp fails.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace rtcore {

/// Weights of morph targets in place of those that the file says, by the names of their nodes.
using ColladaWeights = std::map<std::string, float, std::less<>>;

/// The names of nodes without content begin so whose place along X is the weight of a target, where the file
/// animates it: in a pose they are what counts.
inline constexpr std::string_view kWeightNode = "rtsuite-weight-";

/// The text of a .dae of which the morph controllers are gone: where they stood stand their geometries, moved
/// as far as the weights say. Of several controllers of one geometry the first counts, and normals are moved
/// where targets have as many. Channels that animate weights move nodes of their own, see above. Nothing
/// where the file is no .dae or has no such controller. Throws as openFileBytes() does.
std::optional<std::string> colladaWithoutMorphs(const std::filesystem::path& path,
                                                const ColladaWeights& weights = {});

} // namespace rtcore
