/// What a pixel sees first.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/math/vec.h"
#include "rtcore/shading/primary_hits.h"

namespace rtcore {

/// Of one of its samples, near its middle.
struct SeenPoint {
    Vec3 position;
    Vec3 normal;                     ///< PrimaryHit::normal
    Colour surfaceFraction = kWhite; ///< 0..1: the fraction of the radiance that is PrimaryHit::surfaceLight
    Colour tint;                     ///< PrimaryHit::tint, where something is mirrored
    float specularDistance = 0; ///< PrimaryHit::specularDistance; 0 also where next to nothing is mirrored
    bool any = false;           ///< false: the sample saw the background

    SeenPoint() = default;
    /// `radiance` of the sample.
    SeenPoint(const PrimaryHit& hit, Colour radiance);
};

} // namespace rtcore
