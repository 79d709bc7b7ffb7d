/// Half-spaces: what planes leave.
#pragma once

#include "rtcore/math/box.h"
#include "rtcore/math/vec.h"

namespace rtcore {

/// dot(normal, x) <= offset is kept.
struct HalfSpace {
    Vec3 normal; ///< of length 1
    float offset = 0;
};

/// Of a box, farthest along a direction.
inline Vec3 farthestCorner(const Box3& box, Vec3 direction) {
    Vec3 corner;
    for (int a = 0; a < 3; ++a) corner[a] = direction[a] > 0 ? box.hi[a] : box.lo[a];
    return corner;
}

} // namespace rtcore
