/// The nodes of the scene that a glTF file shows.
#pragma once

#include "rtcore/io/import/gltf/json_members.h"
#include "rtcore/io/import/mesh/affine.h"
#include "rtcore/scene/local_origin.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace rtcore::gltf {

/// A rotation (x, y, z, w), whose length need not be 1, between a scale and a translation. Number: float, as
/// near models have it, or double.
template <typename Number>
Affine affineOf(const std::array<Number, 3>& translation, const std::array<Number, 4>& rotation,
                const std::array<Number, 3>& scale);

/// The world in which nodes stand: that of the file, less an origin. Where that is not zero, all is double.
class World {
  public:
    explicit World(const LocalOrigin& origin);
    /// From the coordinates of what is below no node.
    const Affine& ofFile() const { return ofFile_; }
    /// From a node's coordinates to its parent's, or of one without a parent to the world's.
    Affine localOf(const Json& node, bool isRoot) const;

  private:
    bool precise_;
    Affine ofFile_;
};

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

/// Of the stated scene, else of the first, else all nodes that are no children.
std::vector<std::size_t> rootsOf(const Json& root);
/// By KHR_node_visibility, with all below it.
bool isHidden(const Json& node);

/// The roots and all below them that is not hidden. The graph has no cycles, and what it stands for fits into
/// memory (scene_meshes.h, shownOf).
NodeWalk walkNodes(const Json& root, const World& world);

/// The numbers of its nodes, each behind all below it: the order in which Assimp comes to materials, cameras
/// and lights, and so the one that they keep.
std::vector<std::size_t> leavesFirst(const NodeWalk& walk);

/// The names of the nodes from the root on, with slashes between them; without the root's where it is the
/// only one.
std::string pathOf(const Json& root, const NodeWalk& walk, std::size_t placed);

/// What a node is called: its name, else its number.
std::string nodeName(const Json& root, std::size_t node);

} // namespace rtcore::gltf
