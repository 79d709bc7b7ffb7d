/// Animations of glTF files, as values of the nodes that they move.
#pragma once

#include "rtcore/io/import/gltf/accessors.h"
#include "rtcore/io/import/gltf/json_members.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace rtcore::gltf {

/// "" for one without a name.
std::vector<std::string> animationNames(const Json& root);

/// Sets translation, rotation, scale and weights of the nodes of `root` to what an animation makes of them at
/// `seconds`, or at its first key where that is nothing. A matrix goes. Values before the first key of a
/// channel and behind its last one are theirs. Returns how many channels are damaged and were passed over:
/// keys that go back, numbers that do not agree or are none.
std::size_t animate(Json& root, std::size_t animation, std::optional<double> seconds, Accessors& accessors);

} // namespace rtcore::gltf
