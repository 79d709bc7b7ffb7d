/// Input of a rendering: scene, camera and settings.
#pragma once

#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/scene/camera.h"
#include "rtcore/scene/scene.h"
#include "rtcore/settings/render_settings.h"

namespace rtcore {

/// Everything must outlive the user of the view, and stay as it is while images of it are made.
struct View {
    const Scene& scene;
    const RayTracer& tracer; ///< of the scene's mesh
    const Camera& camera;
    const RenderSettings& settings;
};

/// Those of an image with a pixel for each square of `block` x `block` pixels, also for those that the right
/// or lower edge cuts. Its rays are CameraRays::coarser().
inline RenderSettings coarserSettings(const RenderSettings& settings, int block) {
    RenderSettings coarse = settings;
    coarse.width = (coarse.width + block - 1) / block;
    coarse.height = (coarse.height + block - 1) / block;
    return coarse;
}

} // namespace rtcore
