/// Where a new ray starts so that it does not hit the surface that it leaves.
#pragma once

#include "rtcore/math/vec.h"

#include <bit>
#include <cmath>
#include <cstdint>

namespace rtcore {

/// `p` moved to the side of the unit normal `n` by about 256 units in its last place, per axis, so that the step
/// suits the rounding error wherever `p` lies (Waechter and Binder 2019, "A Fast and Robust Method for Avoiding
/// Self-Intersection").
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
