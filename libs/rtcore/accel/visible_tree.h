/// The tree of a model some of whose triangles are hidden. Rays hit what is left with the same bits by each.
#pragma once

#include "rtcore/accel/build_options.h"
#include "rtcore/accel/kd_tree.h"
#include "rtcore/scene/mesh.h"

#include <cstdint>
#include <span>

namespace rtcore {

// `hidden`: one value for each triangle, not 0: it is.

/// At once: a tree with the same planes and bounds whose leaves lack the hidden triangles; what has no
/// triangles left is one empty leaf. The arrays are as long as before, with what no node refers to any more
/// between the rest. Linear time, by all threads; memory of its own.
KdTree visibleTree(const KdTree& tree, std::span<const std::uint8_t> hidden);

/// By which rays are quicker: a tree built of what is left. `bounds` are those of the tree of all triangles,
/// which it keeps. Throws what buildKdTree() throws.
KdTree buildVisibleTree(const Mesh& mesh, std::span<const std::uint8_t> hidden, const Box3& bounds,
                        BuildOptions options = {}, BuildProgress* progress = nullptr);

} // namespace rtcore
