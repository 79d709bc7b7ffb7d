#include "rtcore/render/frame_renderer.h"

#include "rtcore/platform/task_errors.h"
#include "rtcore/platform/threads.h"
#include "rtcore/render/camera_rays.h"
#include "rtcore/render/tile.h"

#include <algorithm>

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

FrameRenderer::FrameRenderer() = default;
FrameRenderer::~FrameRenderer() = default;

TileRenderer& FrameRenderer::rendererOfThread(int thread) {
    std::unique_ptr<TileRenderer>& renderer = renderers_[static_cast<std::size_t>(thread)];
    if (renderer == nullptr) renderer = std::make_unique<TileRenderer>();
    return *renderer;
}

bool FrameRenderer::render(const Scene& scene, const RayTracer& tracer, const Camera& camera,
                           const RenderSettings& settings, int threads, RenderControl& control,
                           Frame& frame) {
    const CameraRays view(camera, settings.width, settings.height);
    return renderView(scene, tracer, view, settings, threads, control, frame);
}

bool FrameRenderer::renderCoarse(const Scene& scene, const RayTracer& tracer, const Camera& camera,
                                 const RenderSettings& settings, int block, int threads,
                                 RenderControl& control, Frame& frame) {
    const CameraRays view(camera, settings.width, settings.height);
    RenderSettings coarse = settings;
    coarse.width = (settings.width + block - 1) / block;
    coarse.height = (settings.height + block - 1) / block;
    coarse.antialiasing = 1;
    return renderView(scene, tracer, view.coarser(block), coarse, threads, control, frame);
}

bool FrameRenderer::renderView(const Scene& scene, const RayTracer& tracer, const CameraRays& view,
                               const RenderSettings& settings, int threads, RenderControl& control,
                               Frame& frame) {
    prepare(frame, settings);
    materials_.prepare(scene, settings);
    stageTimes_ = {};
    const TileGrid grid(settings, materials_.anyOnward());
    control.tilesDone = 0;
    control.tiles = static_cast<std::uint64_t>(grid.count());
    const int team = threadsFor(threads);
    if (renderers_.size() < static_cast<std::size_t>(team)) renderers_.resize(static_cast<std::size_t>(team));
    TaskErrors errors;
#pragma omp parallel num_threads(team) default(shared)
    errors.guard([&] {
        TileRenderer& renderer = rendererOfThread(threadNumber());
        renderer.begin(scene, tracer, settings, materials_, view, control.cancel, measureStages_);
        // In the order of the picture: its last row of tiles is the one that its lower edge cuts.
#pragma omp for schedule(dynamic, 1) nowait
        for (int tile = 0; tile < grid.count(); ++tile) {
            if (control.cancel.load(std::memory_order_relaxed) || errors.any()) continue;
            errors.guard([&] {
                renderer.render(grid.area(tile), frame);
                const bool whole = !control.cancel.load(std::memory_order_relaxed);
                if (whole && control.finished != nullptr) control.finished->add(grid.area(tile));
            });
            control.tilesDone.fetch_add(1, std::memory_order_relaxed);
        }
#pragma omp critical(rtcore_statistics)
        {
            frame.statistics.add(renderer.statistics());
            stageTimes_.add(renderer.stageTimes());
        }
    });
    errors.rethrow();
    return !control.cancel;
}

bool renderFrame(const Scene& scene, const RayTracer& tracer, const Camera& camera,
                 const RenderSettings& settings, int threads, RenderControl& control, Frame& frame) {
    return FrameRenderer().render(scene, tracer, camera, settings, threads, control, frame);
}

} // namespace rtcore
