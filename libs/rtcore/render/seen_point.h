/// The first surface that a pixel sees.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/math/vec.h"
#include "rtcore/shading/primary_hits.h"

namespace rtcore {

/// The primary hit of one of the pixel's samples, near its middle.
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
