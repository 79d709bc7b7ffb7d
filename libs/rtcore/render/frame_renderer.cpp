#include "rtcore/render/frame_renderer.h"

#include "rtcore/platform/task_errors.h"
#include "rtcore/render/camera_rays.h"
#include "rtcore/render/tile.h"

#ifdef _OPENMP
#include <omp.h>
#endif

namespace rtcore {

namespace {

void prepare(Frame& frame, const RenderSettings& settings) {
    if (frame.radiance.width != settings.width || frame.radiance.height != settings.height) {
        frame.radiance = HdrImage(settings.width, settings.height);
    }
    frame.covered.resize(frame.radiance.pixels.size());
    frame.statistics = {};
}

} // namespace

bool renderFrame(const Scene& scene, const RayTracer& tracer, const Camera& camera,
                 const RenderSettings& settings, int threads, RenderControl& control, Frame& frame) {
    prepare(frame, settings);
    const CameraRays cameraRays(camera, settings.width, settings.height);
    const TileGrid grid(settings);
    control.tilesDone = 0;
    control.tiles = static_cast<std::uint64_t>(grid.count());
    TaskErrors errors;
#ifdef _OPENMP
#pragma omp parallel num_threads(threads > 0 ? threads : omp_get_max_threads()) default(shared)
#else
    static_cast<void>(threads);
#endif
    errors.guard([&] {
        TileRenderer renderer(scene, tracer, settings, cameraRays, control.cancel);
#pragma omp for schedule(dynamic, 1) nowait
        for (int tile = 0; tile < grid.count(); ++tile) {
            if (control.cancel.load(std::memory_order_relaxed) || errors.any()) continue;
            errors.guard([&] { renderer.render(grid, tile, frame); });
            control.tilesDone.fetch_add(1, std::memory_order_relaxed);
        }
#pragma omp critical(rtcore_statistics)
        frame.statistics.add(renderer.statistics());
    });
    errors.rethrow();
    return !control.cancel;
}

} // namespace rtcore
