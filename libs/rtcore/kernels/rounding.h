/// How much rounding is allowed for, the same in every kernel: they have to enter the same cells.
#pragma once

#include <limits>

namespace rtcore {

/// Plane distances are (s - o) * (1 / d), three roundings; each is taken a little too small where an interval
/// begins and too large where it ends, so that no ray slips between two cells (Ize 2013, "Robust BVH ray
/// traversal").
inline constexpr float kPlaneDown = 1 - 6 * 0x1p-24F;
inline constexpr float kPlaneUp = 1 + 6 * 0x1p-24F;

/// The largest rounding error of distances, as a fraction of the size that it grows with: in the leaf test
/// the distance of a triangle's farthest corner, from one surface to another in its plane coordinateSize().
inline constexpr float kDistanceError = 0x1p-17F;

/// No hit is farther, however far a ray goes: an infinite distance has overflowed and orders nothing.
inline constexpr float kFarthestHit = std::numeric_limits<float>::max();

/// Hits that lie no further apart than this fraction of what traversal allows for are looked at again: they
/// may be on one surface (one_surface.h).
inline constexpr float kTieFraction = 0.5F;

/// The sum over the axes of the largest coordinate of the box [lo, hi].
inline float coordinateSize(const float (&lo)[3], const float (&hi)[3]) {
    const auto size = [](float x) { return x < 0 ? -x : x; };
    float sum = 0;
    for (int axis = 0; axis < 3; ++axis)
        sum += size(lo[axis]) > size(hi[axis]) ? size(lo[axis]) : size(hi[axis]);
    return sum;
}

} // namespace rtcore
