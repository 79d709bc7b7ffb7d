/// Light that the rays of a hemisphere bring to their points: vector code.
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

/// Light of a ray that escapes.
struct SkySource {
    const EnvironmentLight* light = nullptr;
    Colour scale;                   ///< times that
    const FogMedium* fog = nullptr; ///< on its endless way; null where there is none
};

/// Rays, one for each sum, from `first` on.
struct SkyRays {
    const RayWave& rays;
    std::size_t first, count;
};

/// Sums over the rays of each point, with room for whole blocks of kWaveBlock.
struct SkySums {
    ArraysOf3 arrived; ///< the radiance that they bring
    ArraysOf3 passing; ///< what is left of it on the way: 0 of a ray that ends at a surface, else up to 1
    ArraysOf3 whole;   ///< what they would bring with nothing in the way
};

/// Adds rays of which those bring all that are not `occluded` (0), the others nothing.
void addSky(const SkySource& sky, const SkyRays& rays, const std::uint8_t* occluded, const SkySums& sums);
/// Adds rays that bring that part.
void addSky(const SkySource& sky, const SkyRays& rays, const Colour* passing, const SkySums& sums);

} // namespace rtcore
