/// The bounds of the part of a triangle inside a cell ("perfect splits"), made a little too large on purpose.
#pragma once

#include "rtcore/math/box.h"
#include "rtcore/math/vec.h"

#include <array>

namespace rtcore {

/// How far clipping reaches beyond a cell: the rounding errors of rays that graze its faces, as an absolute
/// length. `bounds` is the box of the whole scene. (Without it closed meshes leak where cells meet.)
float clipMargin(const Box3& bounds);

/// Bounds of the triangle clipped to `cell` enlarged by `margin`, widened by `margin`, and then limited to
/// both the triangle's own bounds and the cell. Empty when no part is inside. Sutherland and Hodgman 1974, in
/// double.
Box3 clippedBounds(const std::array<Vec3, 3>& corners, const Box3& cell, float margin);

} // namespace rtcore
