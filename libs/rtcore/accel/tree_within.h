/// The tree of what planes leave of a model, for rays that do not go beyond them.
#pragma once

#include "rtcore/accel/build_options.h"
#include "rtcore/accel/kd_tree.h"
#include "rtcore/math/half_space.h"
#include "rtcore/scene/mesh.h"

#include <cstdint>
#include <span>

namespace rtcore {

/// A tree in which rays that stay within all of `halves` find what they find in `tree`, by fewer nodes: cells
/// beyond a plane are gone, together with the nodes that divide them from others. The other leaves, the
/// references and the bounds are those of `tree`, whose storage it shares; nodes that none refers to any more
/// lie between the rest. Copies all nodes, and visits those alone whose cells a plane cuts. One thread.
KdTree treeWithin(const KdTree& tree, std::span<const HalfSpace> halves);

/// By which the same rays are quicker: a tree built of the triangles of which a part is within all of
/// `halves`, each of them whole; treeWithin() takes more cells from it. `hidden`: as in visible_tree.h, or
/// empty where none is; `bounds`: of the tree of all triangles, which it keeps. Throws what buildKdTree()
/// throws.
KdTree buildTreeWithin(const Mesh& mesh, std::span<const std::uint8_t> hidden,
                       std::span<const HalfSpace> halves, const Box3& bounds,
                       const BuildOptions& options = {}, BuildProgress* progress = nullptr);

} // namespace rtcore
