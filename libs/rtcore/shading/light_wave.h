/// What one light adds to all points of a wave, and the shadow rays that decide whether it does.
#pragma once

#include "rtcore/kernels/ray_wave.h"
#include "rtcore/scene/light.h"
#include "rtcore/shading/surface_wave.h"

#include <cstdint>
#include <vector>

namespace rtcore {

/// Rays towards one light, in the order of the points that they leave.
struct ShadowRays {
    RayWave rays;
    std::vector<std::uint32_t> point; ///< of the surface wave; may be longer than the rays
};

/// Sets surfaces.added to what `light` adds unshadowed to each point, zero where it adds nothing, and
/// `shadows` to one ray for each point where it adds something, unless it is null. Keeps the memory of
/// `shadows`.
void addLight(const Light& light, const MaterialTable& materials, SurfaceWave& surfaces, ShadowRays* shadows);

} // namespace rtcore
