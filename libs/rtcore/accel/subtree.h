/// The tree while it is built: pieces that tasks make independently, and their stitching into the final
/// arrays.
#pragma once

#include "rtcore/accel/kd_tree.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace rtcore {

/// A node inside a piece; children are indices into the same piece.
struct BuildNode {
    static constexpr int kLeaf = 3;

    int axis = kLeaf;
    float split = 0;
    std::uint32_t first = 0;  ///< leaf: first reference; inner: lower child
    std::uint32_t second = 0; ///< leaf: number of references; inner: upper child
};

/// Either one large inner node with two pieces below it, or a small finished tree of its own.
struct Subtree {
    int axis = BuildNode::kLeaf;
    float split = 0;
    std::unique_ptr<Subtree> lower, upper; ///< both or none

    std::vector<BuildNode> nodes;          ///< root first; empty in a large inner node
    std::vector<std::uint32_t> references; ///< triangles of the mesh
};

/// Lays the pieces out in the order that KdTree documents, which depends only on the tree.
/// Makes OpenMP tasks when called inside a parallel region.
/// Throws std::length_error when nodes or references exceed what a node can name.
KdTree stitch(const Subtree& root, const Box3& bounds);

} // namespace rtcore
