/// A kd-tree over the triangles of a mesh: views on flat arrays, built in memory or mapped from a .bsp file.
#pragma once

#include "rtcore/accel/kd_node.h"
#include "rtcore/math/box.h"

#include <cstdint>
#include <memory>
#include <span>

namespace rtcore {

/// Root is node 0. The two children of a node are adjacent and lie after it; the pairs appear in the order in
/// which a depth-first walk (lower child first) meets their parents, and the references of leaves in the
/// order in which it meets the leaves: so the arrays have one valid form for each tree, which
/// validateKdTree() checks. Immutable; safe from many threads.
struct KdTree {
    std::span<const KdNode> nodes;             ///< at least one
    std::span<const std::uint32_t> references; ///< triangle indices; ascending inside a leaf
    Box3 bounds;                               ///< of all triangles; the root's cell

    std::shared_ptr<const void> storage; ///< owns the arrays
};

} // namespace rtcore
