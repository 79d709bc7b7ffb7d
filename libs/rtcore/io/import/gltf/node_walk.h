/// The nodes of the scene that a glTF file shows.
#pragma once

#include "rtcore/io/import/gltf/json_members.h"
#include "rtcore/io/import/mesh/affine.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace rtcore::gltf {

/// A rotation (x, y, z, w), whose length need not be 1, between a scale and a translation.
Affine affineOf(Vec3 translation, const std::array<float, 4>& rotation, Vec3 scale);
/// From a node's coordinates to its parent's.
Affine localOf(const Json& node);

struct PlacedNode {
    static constexpr std::size_t kNoParent = ~std::size_t{0};
    std::size_t node = 0; ///< its number in the file
    Affine toWorld;
    std::size_t parent = kNoParent; ///< its number in the walk
};

struct NodeWalk {
    std::vector<PlacedNode> nodes; ///< depth first, in the order of the file
    bool oneRoot = false;
};

/// Of the stated scene, else of the first, else of all nodes that are no children. Without nodes that
/// KHR_node_visibility hides. Throws FileError BadData for a graph with cycles.
NodeWalk walkNodes(const Json& root);

/// The numbers of its nodes, each behind all below it: the order in which Assimp comes to materials, cameras
/// and lights, and so the one that they keep.
std::vector<std::size_t> leavesFirst(const NodeWalk& walk);

/// The names of the nodes from the root on, with slashes between them; without the root's where it is the
/// only one.
std::string pathOf(const Json& root, const NodeWalk& walk, std::size_t placed);

/// What a node is called: its name, else its number.
std::string nodeName(const Json& root, std::size_t node);

} // namespace rtcore::gltf
