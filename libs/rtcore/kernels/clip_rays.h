/// Clipping whole waves by a plane; vector code.
#pragma once

#include "rtcore/kernels/wave_kernels.h"
#include "rtcore/math/half_space.h"

#include <algorithm>
#include <span>

namespace rtcore {

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

/// The same rays clipped by all of these, with intervals in `tMin` and `tMax`, which have room for all; the
/// same bits by every instruction set.
RaySpan clipRays(std::span<const HalfSpace> halves, RaySpan rays, float* tMin, float* tMax);

} // namespace rtcore
