#include "rtcore/render/frame_renderer.h"

#include "rtcore/platform/task_errors.h"
#include "rtcore/platform/threads.h"
#include "rtcore/render/camera_rays.h"
#include "rtcore/render/tile.h"

#include <algorithm>
#include <utility>

namespace rtcore {

namespace {

void makeRoom(Frame& frame, const RenderSettings& settings) {
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
    aimSamples(view, focus_, samples_);
    return renderAimed(view, control, frame);
}

bool FrameRenderer::renderCoarse(const View& view, int block, RenderControl& control, Frame& frame) {
    aimSamples(view, focus_, samples_);
    samples_.camera = samples_.camera.coarser(block);
    RenderSettings coarse = coarserSettings(view.settings, block);
    coarse.antialiasing = 1;
    coarse.sampling = SamplingPattern::Grid;
    return renderAimed({view.scene, view.tracer, view.camera, coarse}, control, frame);
}

bool FrameRenderer::renderGuides(const View& view, int block, GuideRays rays, RenderControl& control,
                                 Guides& guides) {
    const Scene scene = guideScene(view.scene);
    const RenderSettings settings = guideSettings(coarserSettings(view.settings, block), rays);
    const View seen{scene, view.tracer, view.camera, settings};
    aimSamples(view, focus_, samples_);
    samples_.camera = samples_.camera.coarser(block);
    Frame frame;
    frame.radiance = std::move(guides.albedo);
    frame.covered = std::move(guides.covered);
    const bool aovs = std::exchange(collectAovs_, false), points = std::exchange(collectSeen_, false);
    const Background background = std::exchange(background_, Background::Shown);
    const IndirectLight* const indirect = std::exchange(indirect_, nullptr);
    const bool whole = renderAimed(seen, control, frame, &guides.normals);
    indirect_ = indirect;
    collectAovs_ = aovs;
    collectSeen_ = points;
    background_ = background;
    for (Colour& pixel : frame.radiance.pixels)
        pixel = {std::min(pixel.r, 1.0F), std::min(pixel.g, 1.0F), std::min(pixel.b, 1.0F)};
    guides.albedo = std::move(frame.radiance);
    guides.covered = std::move(frame.covered);
    return whole;
}

void FrameRenderer::beginAovs(const View& view, Frame& frame) const {
    const RenderSettings& settings = view.settings;
    if (collectAovs_) {
        frame.aovs.begin(view.camera, settings.width, settings.height);
    } else {
        frame.aovs.clear();
    }
    if (collectSeen_) {
        frame.seen.resize(frame.radiance.pixels.size()); // tiles write all of them
    } else {
        frame.seen = {};
    }
    if (collectSeen_ && indirect_ != nullptr) {
        frame.matter.resize(frame.seen.size()); // the same
    } else {
        frame.matter = {};
    }
    if (isHidden(background_, view.scene)) {
        frame.transmitted.width = settings.width;
        frame.transmitted.height = settings.height;
        frame.transmitted.pixels.resize(frame.radiance.pixels.size()); // the same
    } else {
        frame.transmitted = {};
    }
    frame.behind = colourBehind(background_, view.scene);
    frame.guides = {};
    frame.metered.clear();
    frame.checked.clear();
    frame.halves = {};
    frame.steady = {};
}

/// Prepares everything that depends on the scene and the settings.
void FrameRenderer::prepare(const View& view) {
    if (indirect_ != nullptr) {
        materials_.prepare(view.scene, view.settings, Colour{});
    } else {
        materials_.prepare(view.scene, view.settings);
    }
    samples_.pattern.prepare(view.settings.sampling, view.settings.antialiasing);
    samples_.lensPattern.prepare(view.settings.antialiasing);
    stageTimes_ = {};
}

bool FrameRenderer::renderPixels(const View& view, std::span<const SampleId> pixels, RenderControl& control,
                                 const RenderedPixels& to, RayStatistics& statistics) {
    // Samples of a part: enough that secondary rays share work, and few enough that all threads have some.
    // Not of the number of threads, since parts decide how sums are rounded.
    constexpr std::size_t kMin = 512, kMax = 8192, kParts = 16;
    aimSamples(view, focus_, samples_);
    prepare(view);
    const auto ofPixel = static_cast<std::size_t>(view.settings.antialiasing) *
                         static_cast<std::size_t>(view.settings.antialiasing);
    const std::size_t samples = std::clamp(pixels.size() * ofPixel / kParts, kMin, kMax);
    const std::size_t size = std::max<std::size_t>(1, samples / ofPixel);
    const auto parts = static_cast<int>((pixels.size() + size - 1) / size);
    control.tilesDone = 0;
    control.tiles = static_cast<std::uint64_t>(parts);
    tapsOfParts_.resize(static_cast<std::size_t>(parts));
    Frame none; // no pixels
    renderParts({view, threadsFor(control.threads), control, none}, parts,
                [&](TileRenderer& renderer, int part) {
                    const std::size_t first = static_cast<std::size_t>(part) * size;
                    const std::size_t count = std::min(size, pixels.size() - first);
                    renderer.renderPixels(pixels.subspan(first, count), to.part(first, count));
                    if (indirect_ != nullptr) keepTaps(renderer, ofPixel, first, part);
                });
    taps_.clear();
    if (indirect_ != nullptr) {
        for (const IndirectTaps& some : tapsOfParts_) {
            taps_.matte.insert(taps_.matte.end(), some.matte.begin(), some.matte.end());
            taps_.lobes.insert(taps_.lobes.end(), some.lobes.begin(), some.lobes.end());
        }
    }
    statistics.add(none.statistics);
    return !control.cancel;
}

/// Those of a part of the pixels, from the first on, which have so many samples each.
void FrameRenderer::keepTaps(const TileRenderer& renderer, std::size_t ofPixel, std::size_t first, int part) {
    IndirectTaps& kept = tapsOfParts_[static_cast<std::size_t>(part)];
    kept.matte.assign(renderer.taps().begin(), renderer.taps().end());
    kept.lobes.assign(renderer.lobes().begin(), renderer.lobes().end());
    const auto take = [&](auto& tap) {
        tap.sample = static_cast<std::uint32_t>(tap.sample / ofPixel + first);
        tap.factor = tap.factor / static_cast<float>(ofPixel);
    };
    std::ranges::for_each(kept.matte, take);
    std::ranges::for_each(kept.lobes, take);
}

bool FrameRenderer::renderAimed(const View& view, RenderControl& control, Frame& frame,
                                std::vector<Vec3>* normals) {
    const RenderSettings& settings = view.settings;
    makeRoom(frame, settings);
    beginAovs(view, frame);
    if (normals != nullptr) normals->assign(frame.radiance.pixels.size(), {});
    prepare(view);
    const TileGrid grid(settings, materials_.anySecondary());
    const bool refined = samplesAdaptively(settings) && frame.transmitted.empty();
    control.tilesDone = 0;
    control.tiles = static_cast<std::uint64_t>(grid.count()) * (refined ? 2 : 1);
    const Work work{view, threadsFor(control.threads), control, frame, normals};
    if (refined) {
        renderAdaptively(work, grid);
    } else {
        renderParts(work, grid.count(), [&](TileRenderer& renderer, int tile) {
            renderer.render(grid.area(tile), frame);
            finish(work, grid.area(tile));
        });
    }
    if (!frame.aovs.empty()) frame.aovs.finish(work.team);
    return !control.cancel;
}

void FrameRenderer::renderAdaptively(const Work& work, const TileGrid& grid) {
    Frame& frame = work.frame;
    adaptive_.begin(work.view.settings);
    renderParts(work, grid.count(), [&](TileRenderer& renderer, int tile) {
        renderer.renderFirst(grid.area(tile), adaptive_, frame);
    });
    if (work.control.cancel) return;
    adaptive_.measure(frame.radiance);
#pragma omp parallel for num_threads(work.team) schedule(static)
    for (int tile = 0; tile < grid.count(); ++tile) adaptive_.choose(grid.area(tile), frame.radiance);
    renderParts(work, grid.count(), [&](TileRenderer& renderer, int tile) {
        renderer.renderRest(grid.area(tile), adaptive_, frame);
        finish(work, grid.area(tile));
    });
}

/// Calls `render` with each part's number and the renderer of a thread, by all threads.
template <typename Render>
void FrameRenderer::renderParts(const Work& work, int parts, Render&& render) {
    const auto team = static_cast<std::size_t>(work.team);
    if (renderers_.size() < team) renderers_.resize(team);
    TaskErrors errors;
    const std::atomic<bool>& cancel = work.control.cancel;
#pragma omp parallel num_threads(work.team) default(shared)
    errors.guard([&] {
        TileRenderer& renderer = rendererOfThread(threadNumber());
        renderer.begin({.view = work.view,
                        .samples = samples_,
                        .materials = materials_,
                        .shadowMaps = maps_,
                        .indirect = indirect_,
                        .cancel = cancel,
                        .measureStages = measureStages_,
                        .aovs = work.frame.aovs.empty() ? nullptr : &work.frame.aovs,
                        .seen = work.frame.seen.empty() ? nullptr : &work.frame.seen,
                        .matter = work.frame.matter.empty() ? nullptr : &work.frame.matter,
                        .hidesBackground = !work.frame.transmitted.empty(),
                        .normals = work.normals});
        // In the order of the image: its last row of tiles is the one that its lower edge cuts.
#pragma omp for schedule(dynamic, 1) nowait
        for (int part = 0; part < parts; ++part) {
            if (cancel.load(std::memory_order_relaxed) || errors.any()) continue;
            errors.guard([&] { render(renderer, part); });
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

} // namespace rtcore
