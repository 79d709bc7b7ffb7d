/// What one light adds to all points of a wave, and the shadow rays that decide whether it does.
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

/// Which part of a lamp with a size each point looks at.
struct LampPart {
    const std::uint32_t *u = nullptr, *v = nullptr; ///< of each point of the wave, and for whole blocks of
                                                    ///< kWaveBlock: a place in the unit square, times 2^32
    std::uint32_t du = 0, dv = 0;                   ///< added to all of them; wraps around
    float share = 1;                                ///< of the lamp's light
    float ofAll = 1; ///< of all parts that a pixel looks at: highlights are no narrower than one of them
};

/// Sets surfaces.added to what `light` adds unshadowed to each point, zero where it adds nothing, and
/// `shadows` to one ray for each point where it adds something, unless it is null. Keeps the memory of
/// `shadows`.
void addLight(const Light& light, const MaterialTable& materials, SurfaceWave& surfaces, ShadowRays* shadows);
/// The same for a part of a lamp with a size (hasSize()): the mean over uniformly distributed parts is its
/// light. Spheres are drawn by the cone that they fill (Shirley, Wang and Zimmerman 1996), rectangles by
/// area.
void addLight(const Light& light, const LampPart& part, const MaterialTable& materials, SurfaceWave& surfaces,
              ShadowRays* shadows);

} // namespace rtcore
