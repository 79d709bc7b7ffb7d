/// What a pixel sees first.
#pragma once

#include "rtcore/math/vec.h"
#include "rtcore/shading/primary_hits.h"

namespace rtcore {

/// Of one of its samples, near its middle.
struct SeenPoint {
    Vec3 position;
    Vec3 normal;        ///< PrimaryHit::normal
    float mirrored = 0; ///< PrimaryHit::mirrored
    bool any = false;   ///< false: the sample saw the background

    SeenPoint() = default;
    explicit SeenPoint(const PrimaryHit& hit)
        : position(hit.position), normal(hit.normal), mirrored(hit.mirrored), any(hit.any()) {}
};

} // namespace rtcore
