/// Learns what the points of an image see of its lights.
#pragma once

#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/pathtracing/light_set.h"
#include "rtcore/pathtracing/visibility_cache.h"
#include "rtcore/scene/scene.h"
#include "rtcore/settings/render_settings.h"
#include "rtcore/shading/surface/material_table.h"

#include <atomic>

namespace rtcore {

/// Must outlive the call.
struct VisibilityTask {
    const Scene& scene;
    const RayTracer& tracer;
    const RenderSettings& settings; ///< of them textures, refractions, path.caustics
    const MaterialTable& materials;
    const LightSet& lights;
    int threads;                             ///< as RenderControl::threads
    const std::atomic<bool>* stop = nullptr; ///< becomes true: what is returned soon is of no use

    bool stopped() const { return stop != nullptr && stop->load(std::memory_order_relaxed); }
};

/// Follows camera rays (directions of unit length) from surface to surface as if all were matte, and straight
/// on through what lets light pass. There it tests rays to the surroundings, at first in all directions, then
/// in those where their light is known to arrive, and to some of the lights. The same for any number of
/// threads and instruction set. Takes some 40 rays for each camera ray and bounce.
VisibilityCache learnVisibility(const VisibilityTask& task, const RayWave& camera);

} // namespace rtcore
