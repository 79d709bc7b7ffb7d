/// What the rays of a hemisphere bring to their points: vector code.
#pragma once

#include "rtcore/kernels/ray_wave.h"
#include "rtcore/scene/environment_light.h"
#include "rtcore/shading/fog/fog.h"
#include "rtcore/shading/surface/surface_wave.h"

#include <cstddef>
#include <cstdint>

namespace rtcore {

/// Adds to `count` sums what passes: t / distance of a ray that hit, else 1. `hits`, from `first` on, has
/// one for each sum.
void addVisible(float* visible, std::size_t count, const HitWave& hits, std::size_t first, float distance);

/// What a ray that escapes brings.
struct Sky {
    const EnvironmentLight* light = nullptr;
    Colour scale;                   ///< times that
    const FogMedium* fog = nullptr; ///< on its endless way; null where there is none
};

/// Rays, one for each sum, from `first` on.
struct SkyRays {
    const RayWave& rays;
    std::size_t first, count;
};

/// Adds what the rays bring that are not `occluded` (0). `sums` has room for whole blocks of kWaveBlock.
void addSky(const Sky& sky, const SkyRays& rays, const std::uint8_t* occluded, const ArraysOf3& sums);
/// Adds what all of them bring, times `arriving`.
void addSky(const Sky& sky, const SkyRays& rays, const Colour* arriving, const ArraysOf3& sums);

} // namespace rtcore
