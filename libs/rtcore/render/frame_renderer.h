/// From a scene and a camera to a picture of unbounded linear radiance.
#pragma once

#include "rtcore/kernels/ray_statistics.h"
#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/scene/image.h"
#include "rtcore/scene/scene.h"
#include "rtcore/settings/render_settings.h"

#include <atomic>
#include <cstdint>
#include <vector>

namespace rtcore {

struct Frame {
    HdrImage radiance; ///< settings.width x settings.height, averaged over the samples of each pixel
    std::vector<std::uint8_t>
        covered; ///< per pixel: 255 where all samples hit geometry, 0 where all saw the background
    RayStatistics statistics;
};

/// Shared with threads that show progress or stop the work. One frame at a time.
struct RenderControl {
    std::atomic<bool> cancel{false};
    std::atomic<std::uint64_t> tilesDone{0};
    std::atomic<std::uint64_t> tiles{0}; ///< of the whole frame; 0 before it starts
};

/// Renders into `frame`, whose memory is reused when the size fits. `threads` = 0: all cores; the picture has
/// the same bits for every number. Returns false when control.cancel was set, with `frame` undefined.
bool renderFrame(const Scene& scene, const RayTracer& tracer, const Camera& camera,
                 const RenderSettings& settings, int threads, RenderControl& control, Frame& frame);

} // namespace rtcore
