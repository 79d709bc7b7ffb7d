/// The first surface that a pixel sees.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/math/vec.h"
#include "rtcore/shading/primary_hits.h"

#include <cstdint>

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

/// By which the light of a surface that a pixel sees follows what is learned of indirect light: the radiance
/// of the surface without that, the fraction of it that is scattered, the shading normal and that of the
/// face. Packed by packLight() and packDirection(); no albedo: it does not follow.
struct SeenMatter {
    std::uint32_t direct = 0, albedo = 0, normal = 0, face = 0;

    SeenMatter() = default;
    /// `indirect`: the part of the surface's radiance that this tap adds.
    SeenMatter(Colour surface, Colour indirect, const IndirectTap& tap);
};

} // namespace rtcore
