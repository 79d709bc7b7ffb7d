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

bool FrameRenderer::render(const View& view, RenderControl& control, Frame& frame) {
    aim(view);
    return renderAimed(view, control, frame);
}

bool FrameRenderer::renderCoarse(const View& view, int block, RenderControl& control, Frame& frame) {
    aim(view);
    samples_.camera = samples_.camera.coarser(block);
    RenderSettings coarse = view.settings;
    coarse.width = (coarse.width + block - 1) / block;
    coarse.height = (coarse.height + block - 1) / block;
    coarse.antialiasing = 1;
    coarse.sampling = SamplingPattern::Grid;
    return renderAimed({view.scene, view.tracer, view.camera, coarse}, control, frame);
}

/// The camera and its lens; what is in the middle is that of the whole image.
void FrameRenderer::aim(const View& view) {
    const auto width = static_cast<float>(view.settings.width);
    const auto height = static_cast<float>(view.settings.height);
    CameraRays& rays = samples_.camera;
    rays = CameraRays(view.camera, view.settings.width, view.settings.height);
    samples_.lens = {};
    const DepthOfFieldSettings& lens = view.settings.depthOfField;
    if (!lens.on || rays.parallel()) return; // an orthographic view has no lens
    const float focus =
        lens.focus > 0 ? lens.focus : focus_.distance(view.tracer, rays, width * 0.5F, height * 0.5F);
    samples_.lens = makeLens(rays, view.camera.horizontalFov, lens.fNumber, focus, view.scene.metresPerUnit);
    samples_.aperture.prepare(lens.blades);
}

void FrameRenderer::beginAovs(const View& view, Frame& frame) const {
    const RenderSettings& settings = view.settings;
    if (collectAovs_) {
        frame.aovs.begin(view.camera, settings.width, settings.height);
    } else {
        frame.aovs.clear();
    }
}

bool FrameRenderer::renderAimed(const View& view, RenderControl& control, Frame& frame) {
    const RenderSettings& settings = view.settings;
    beginAovs(view, frame);
    prepare(frame, settings);
    materials_.prepare(view.scene, settings);
    samples_.pattern.prepare(settings.sampling, settings.antialiasing);
    samples_.lensPattern.prepare(settings.antialiasing);
    stageTimes_ = {};
    const TileGrid grid(settings, materials_.anySecondary());
    const bool refined = samplesAdaptively(settings);
    control.tilesDone = 0;
    control.tiles = static_cast<std::uint64_t>(grid.count()) * (refined ? 2 : 1);
    const Work work{view, threadsFor(control.threads), control, frame};
    const auto team = static_cast<std::size_t>(work.team);
    if (renderers_.size() < team) renderers_.resize(team);
    if (refined) {
        renderAdaptively(work, grid);
    } else {
        renderTiles(work, grid, [&](TileRenderer& renderer, const PixelArea& tile) {
            renderer.render(tile, frame);
            finish(work, tile);
        });
    }
    if (!frame.aovs.empty()) frame.aovs.finish(work.team);
    return !control.cancel;
}

void FrameRenderer::renderAdaptively(const Work& work, const TileGrid& grid) {
    Frame& frame = work.frame;
    adaptive_.begin(work.view.settings);
    renderTiles(work, grid, [&](TileRenderer& renderer, const PixelArea& tile) {
        renderer.renderFirst(tile, adaptive_, frame);
    });
    if (work.control.cancel) return;
    adaptive_.measure(frame.radiance);
#pragma omp parallel for num_threads(work.team) schedule(static)
    for (int tile = 0; tile < grid.count(); ++tile) adaptive_.choose(grid.area(tile), frame.radiance);
    renderTiles(work, grid, [&](TileRenderer& renderer, const PixelArea& tile) {
        renderer.renderRest(tile, adaptive_, frame);
        finish(work, tile);
    });
}

/// Calls `render` with each tile and the renderer of a thread, by all threads.
template <typename Render>
void FrameRenderer::renderTiles(const Work& work, const TileGrid& grid, Render&& render) {
    TaskErrors errors;
    const std::atomic<bool>& cancel = work.control.cancel;
#pragma omp parallel num_threads(work.team) default(shared)
    errors.guard([&] {
        TileRenderer& renderer = rendererOfThread(threadNumber());
        renderer.begin({.view = work.view,
                        .samples = samples_,
                        .materials = materials_,
                        .shadowMaps = maps_,
                        .cancel = cancel,
                        .measureStages = measureStages_,
                        .aovs = work.frame.aovs.empty() ? nullptr : &work.frame.aovs});
        // In the order of the image: its last row of tiles is the one that its lower edge cuts.
#pragma omp for schedule(dynamic, 1) nowait
        for (int tile = 0; tile < grid.count(); ++tile) {
            if (cancel.load(std::memory_order_relaxed) || errors.any()) continue;
            errors.guard([&] { render(renderer, grid.area(tile)); });
            work.control.tilesDone.fetch_add(1, std::memory_order_relaxed);
        }
#pragma omp critical(rtcore_statistics)
        {
            work.frame.statistics.add(renderer.statistics());
            stageTimes_.add(renderer.stageTimes());
        }
    });
    errors.rethrow();
}

void FrameRenderer::finish(const Work& work, const PixelArea& tile) {
    const bool whole = !work.control.cancel.load(std::memory_order_relaxed);
    if (whole && work.control.finished != nullptr) work.control.finished->add(tile);
}

bool renderFrame(const View& view, RenderControl& control, Frame& frame) {
    return FrameRenderer().render(view, control, frame);
}

} // namespace rtcore
