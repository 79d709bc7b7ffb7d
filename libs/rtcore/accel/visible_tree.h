/// The tree of a model some of whose triangles are hidden.
#pragma once

#include "rtcore/accel/kd_tree.h"

#include <cstdint>
#include <span>

namespace rtcore {

/// A tree with the same planes and bounds whose leaves lack the hidden triangles; what has no triangles left
/// is one empty leaf. Rays so pay nothing for what is hidden, nor for the question whether anything is, and
/// hit what is left with the same bits. `hidden`: one value for each triangle, not 0: it is. Linear time,
/// about 20 ns for a node; memory of its own.
KdTree visibleTree(const KdTree& tree, std::span<const std::uint8_t> hidden);

} // namespace rtcore
