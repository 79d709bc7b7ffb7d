/// The nodes that have something of a list of the file.
#pragma once

#include "rtcore/io/import/gltf/node_walk.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace rtcore::gltf {

/// Those for which `numberOf` has a number, leaves first.
template <typename NumberOf>
std::vector<const PlacedNode*> nodesWith(const Json& root, const NodeWalk& walk, NumberOf numberOf) {
    std::vector<const PlacedNode*> nodes;
    for (const std::size_t i : leavesFirst(walk))
        if (numberOf(member(root, "nodes")[walk.nodes[i].node])) nodes.push_back(&walk.nodes[i]);
    return nodes;
}

/// Near enough for lights and cameras to stand there.
inline bool isPlace(Vec3 p) {
    constexpr float kFarthest = 1e16F;
    return std::fabs(p.x) <= kFarthest && std::fabs(p.y) <= kFarthest && std::fabs(p.z) <= kFarthest;
}

} // namespace rtcore::gltf
