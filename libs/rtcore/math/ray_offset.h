/// Where a new ray starts so that it does not hit the surface that it leaves.
#pragma once

#include "rtcore/math/vec.h"

#include <bit>
#include <cmath>
#include <cstdint>

namespace rtcore {

/// How far off its triangle, along its unit normal, a ray has to start that must not hit it. `extent` holds
/// the largest |x|, |y| and |z| of the corners. A point on the triangle and the test of a ray against it are
/// rounded in proportion to the corners, even where the point itself is near the origin; so the step is 64
/// roundings of their share along the normal, and 16 of the largest for rays that graze. It suits scenes of
/// any size.
inline float surfaceClearance(Vec3 extent, Vec3 normal) {
    const float across =
        extent.x * std::fabs(normal.x) + extent.y * std::fabs(normal.y) + extent.z * std::fabs(normal.z);
    return (4 * across + std::fmax(extent.x, std::fmax(extent.y, extent.z))) * 0x1p-20F;
}

/// For a point whose triangle is not known: `p` moved to the side of the unit normal `n` by about 256 units
/// in its last place, per axis, so that the step suits the rounding error wherever `p` lies (Waechter and
/// Binder 2019, "A Fast and Robust Method for Avoiding Self-Intersection").
inline Vec3 offsetRayOrigin(Vec3 p, Vec3 n) {
    constexpr float kNearZero = 1.0F / 32;
    constexpr float kSmallStep = 1.0F / 65536;
    constexpr float kUnits = 256;
    Vec3 moved;
    for (int axis = 0; axis < 3; ++axis) {
        // Unsigned, since the bits of -0 minus a few are less than any signed number.
        const auto units = static_cast<std::uint32_t>(static_cast<std::int32_t>(kUnits * n[axis]));
        const auto bits = std::bit_cast<std::uint32_t>(p[axis]);
        const auto away = std::bit_cast<float>(p[axis] < 0 ? bits - units : bits + units);
        moved[axis] = std::fabs(p[axis]) < kNearZero ? p[axis] + kSmallStep * n[axis] : away;
    }
    return moved;
}

} // namespace rtcore
