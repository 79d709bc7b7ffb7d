/// Where a new ray starts so that it does not hit the surface that it leaves.
#pragma once

#include "rtcore/math/vec.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

/// How far off its triangle (a, b, c), along the unit normal, a ray has to start that must not hit it. A
/// point on the triangle and the test of a ray against it are rounded in proportion to the corners, even
/// where the point itself is near the origin; so the step is 64 roundings of their largest coordinates' share
/// along the normal, and 16 of the largest of all for rays that graze. It suits scenes of any size. (Waechter
/// and Binder 2019, "A Fast and Robust Method for Avoiding Self-Intersection", steps by the point alone: too
/// little where a large triangle passes near the origin.)
inline float surfaceClearance(Vec3 a, Vec3 b, Vec3 c, Vec3 normal) {
    const auto largest = [](float x, float y, float z) {
        return std::max(std::fabs(x), std::max(std::fabs(y), std::fabs(z)));
    };
    const Vec3 extent{largest(a.x, b.x, c.x), largest(a.y, b.y, c.y), largest(a.z, b.z, c.z)};
    const float across =
        extent.x * std::fabs(normal.x) + extent.y * std::fabs(normal.y) + extent.z * std::fabs(normal.z);
    return (4 * across + std::max(extent.x, std::max(extent.y, extent.z))) * 0x1p-20F;
}

} // namespace rtcore
