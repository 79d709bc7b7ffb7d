/// How much rounding is allowed for, the same in every kernel: they have to enter the same cells.
#pragma once

namespace rtcore {

/// Plane distances are (s - o) * (1 / d), three roundings; each is taken a little too small where an interval
/// begins and too large where it ends, so that no ray slips between two cells (Ize 2013, "Robust BVH ray
/// traversal").
inline constexpr float kPlaneDown = 1 - 6 * 0x1p-24F;
inline constexpr float kPlaneUp = 1 + 6 * 0x1p-24F;

/// What rounding may do to the leaf test's distance, as a fraction of that of the farthest corner.
inline constexpr float kDistanceError = 0x1p-17F;

} // namespace rtcore
