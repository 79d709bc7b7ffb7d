/// The tree of what planes leave of a model, for rays that do not go beyond them.
#pragma once

#include "rtcore/accel/kd_tree.h"
#include "rtcore/math/half_space.h"

#include <span>

namespace rtcore {

/// A tree in which rays that stay within all of `halves` find what they find in `tree`, by fewer nodes: cells
/// beyond a plane are gone, together with the nodes that divide them from others. The other leaves, the
/// references and the bounds are those of `tree`, whose storage it shares; nodes that none refers to any more
/// lie between the rest. Copies all nodes, and visits those alone whose cells a plane cuts. One thread.
KdTree treeWithin(const KdTree& tree, std::span<const HalfSpace> halves);

} // namespace rtcore
