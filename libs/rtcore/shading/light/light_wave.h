/// Unshadowed direct light of one light at all points of a wave, and the shadow rays to it.
#pragma once

#include "rtcore/kernels/ray_wave.h"
#include "rtcore/scene/light.h"
#include "rtcore/shading/surface/surface_wave.h"

#include <cstdint>
#include <vector>

namespace rtcore {

/// Rays towards one light, in the order of the points that they leave.
struct ShadowRays {
    RayWave rays;
    std::vector<std::uint32_t> point; ///< of the surface wave; may be longer than the rays
};

/// Which stratum of an area light is sampled for each point.
struct LightStrata {
    const std::uint32_t *u = nullptr, *v = nullptr; ///< of each point of the wave, and for whole blocks of
                                                    ///< kWaveBlock: a position in the unit square, times 2^32
    std::uint32_t du = 0, dv = 0;                   ///< added to all of them; wraps around
    float weight = 1;                               ///< of one stratum in the whole light
    float ofAll = 1; ///< of one of all strata that a pixel samples: highlights are widened to it
};

/// Visibility of a light that is known without tracing, by point of the wave and for whole blocks of
/// kWaveBlock: a bit that is set in `clear` where all of it arrives, in `dark` where nothing does.
struct KnownVisibility {
    const std::uint32_t *clear, *dark;
    std::uint32_t bit;
};

/// Sets surfaces.contribution to what `light` adds unshadowed to each point, zero where it adds nothing, and
/// `shadows` to one ray for each point where it adds something and is not `known`, unless it is null. Keeps
/// the memory of `shadows`.
void addLight(const Light& light, const MaterialTable& materials, SurfaceWave& surfaces, ShadowRays* shadows,
              const KnownVisibility* known = nullptr);
/// The same for one stratum of an area light (isAreaLight()): the mean over uniformly distributed strata is
/// its light. Spheres are sampled uniformly in the cone that they fill (Shirley, Wang and Zimmerman 1996),
/// rectangles by area, discs by their projection.
void addLight(const Light& light, const LightStrata& strata, const MaterialTable& materials,
              SurfaceWave& surfaces, ShadowRays* shadows, const KnownVisibility* known = nullptr);

} // namespace rtcore
