/// Clipping whole waves by a plane; vector code.
#pragma once

#include "rtcore/kernels/wave_kernels.h"
#include "rtcore/math/vec.h"

#include <algorithm>

namespace rtcore {

/// dot(normal, x) <= offset is kept.
struct HalfSpace {
    Vec3 normal;
    float offset = 0;
};

/// The part of a ray's interval that is kept; where none is, tMin > tMax. `speed`: of the ray along the
/// normal; `room`: from its origin to the plane.
inline void clipInterval(float speed, float room, float& tMin, float& tMax) {
    const float t = room / speed;
    if (speed > 0) {
        tMax = std::min(tMax, t);
    } else if (speed < 0) {
        tMin = std::max(tMin, t);
    } else if (room < 0) {
        tMax = -1;
    }
}

/// The same of all rays, whose intervals are `tMin` and `tMax`, as long as `rays`; the same bits by every
/// instruction set.
void clipRays(const HalfSpace& half, const RaySpan& rays, float* tMin, float* tMax);

} // namespace rtcore
