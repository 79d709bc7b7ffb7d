#include "rtcore/live/live_renderer.h"

#include "rtcore/live/hole_filling.h"
#include "rtcore/platform/task_errors.h"
#include "rtcore/platform/threads.h"

#include <algorithm>
#include <utility>

namespace rtcore {

namespace {

constexpr int kGuideTile = 64; ///< pixels; even, so that the pattern of guides is the same in each

/// Calls `work` with each tile of the image, by `threads`, until `control` is cancelled.
template <typename Work>
void forEachTile(const ImagePlane& plane, [[maybe_unused]] int threads, const RenderControl& control,
                 Work&& work) {
    const int columns = (plane.width + kGuideTile - 1) / kGuideTile,
              rows = (plane.height + kGuideTile - 1) / kGuideTile;
    TaskErrors errors;
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
    for (int tile = 0; tile < columns * rows; ++tile) {
        if (control.cancel.load(std::memory_order_relaxed) || errors.any()) continue;
        const int left = tile % columns * kGuideTile, top = tile / columns * kGuideTile;
        errors.guard([&] {
            work(PixelArea{left, top, std::min(kGuideTile, plane.width - left),
                           std::min(kGuideTile, plane.height - top)});
        });
    }
    errors.rethrow();
}

/// What is known of lights at a point, but for those that some of the points around see and others do not:
/// the edges of shadows stay where they are. In turns nothing counts as known, so that no error lasts.
LightVisibility surelyKnown(const LiveImage& image, int x, int y, std::uint32_t number) {
    const LivePoint& point = image.at(x, y);
    if (!point.lit() || (turnOf(x, y) + number) % kTurns == 0) return {};
    unsigned clear = 0, dark = 0;
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, image.plane.height - 1); ++v) {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, image.plane.width - 1); ++u) {
            clear |= image.at(u, v).lights.clear;
            dark |= image.at(u, v).lights.dark;
        }
    }
    const unsigned sure = ~(clear & dark);
    return {static_cast<std::uint16_t>(point.lights.clear & sure),
            static_cast<std::uint16_t>(point.lights.dark & sure)};
}

} // namespace

LiveRenderer::LiveRenderer() = default;
LiveRenderer::~LiveRenderer() = default;

bool LiveRenderer::draws(const View& view) {
    const RenderSettings& settings = view.settings;
    return view.camera.kind == CameraKind::Perspective && settings.antialiasing == 1 &&
           settings.sampling == SamplingPattern::Grid && !settings.depthOfField.on;
}

void LiveRenderer::begin(const View& view) {
    const int width = view.settings.width, height = view.settings.height;
    const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    present_.plane = ImagePlane(CameraRays(view.camera, width, height), width, height);
    present_.points.resize(count);
    if (!past_.points.empty()) return;
    past_.plane = present_.plane; // nothing is known, not even what was seen
    past_.points.assign(count, {});
}

bool LiveRenderer::render(const View& view, const LiveBudget& budget, RenderControl& control, Frame& frame) {
    begin(view);
    const std::size_t count = present_.points.size();
    frame.radiance.width = present_.plane.width;
    frame.radiance.height = present_.plane.height;
    frame.radiance.pixels.resize(count);
    frame.covered.resize(count);
    frame.statistics = {};
    frame.aovs.clear();
    const int threads = threadsFor(control.threads);
    if (!findPoints(view, budget, control, frame.statistics)) return false;
    choice_.choose(present_, budget.newPoints, number_, threads);
    if (!lightPoints(view, control, frame)) return false;
    forEachTile(present_.plane, threads, control,
                [&](const PixelArea& area) { showPoints(present_, area, frame); });
    if (control.cancel) return false;
    std::swap(past_, present_);
    ++number_;
    return true;
}

bool LiveRenderer::keep(const View& view, const Frame& frame, RenderControl& control) {
    begin(view);
    RayStatistics rays;
    if (!findPoints(view, {.guides = 1, .newPoints = 0}, control, rays)) return false;
    for (std::size_t i = 0; i < present_.points.size(); ++i) {
        LivePoint& point = present_.points[i];
        point.light = packLight(frame.radiance.pixels[i]);
        point.across = point.down = 0;
        point.age = 0;
        point.flags = static_cast<std::uint8_t>(point.flags | LivePoint::kLit);
    }
    std::swap(past_, present_);
    ++number_;
    return true;
}

bool LiveRenderer::findPoints(const View& view, const LiveBudget& budget, RenderControl& control,
                              RayStatistics& rays) {
    const int threads = threadsFor(control.threads);
    if (passes_.size() < static_cast<std::size_t>(threads)) passes_.resize(static_cast<std::size_t>(threads));
    for (std::unique_ptr<GuidePass>& pass : passes_) {
        if (pass == nullptr) pass = std::make_unique<GuidePass>();
        pass->begin();
    }
    materials_.prepare(view.scene, view.settings);
    const CameraRays camera(view.camera, view.settings.width, view.settings.height);
    const GuidePass::Task task{view.scene, view.tracer, materials_, camera, {budget.guides, number_}, past_};
    forEachTile(present_.plane, threads, control, [&](const PixelArea& area) {
        passes_[static_cast<std::size_t>(threadNumber())]->trace(task, area, present_);
    });
    if (budget.guides > 1) {
        forEachTile(present_.plane, threads, control, [&](const PixelArea& area) {
            passes_[static_cast<std::size_t>(threadNumber())]->guess(task, area, present_);
        });
    }
    for (const std::unique_ptr<GuidePass>& pass : passes_) rays.add(pass->statistics());
    return !control.cancel;
}

bool LiveRenderer::lightPoints(const View& view, RenderControl& control, Frame& frame) {
    const std::vector<SampleId>& chosen = choice_.chosen();
    light_.resize(chosen.size());
    visibility_.resize(chosen.size());
    for (std::size_t i = 0; i < chosen.size(); ++i)
        visibility_[i] = surelyKnown(present_, chosen[i].x, chosen[i].y, number_);
    newPoints_ = static_cast<double>(chosen.size()) / static_cast<double>(present_.points.size());
    RayStatistics traced;
    if (!renderer_.renderPixels(view, chosen, control, light_, traced, visibility_)) return false;
    frame.statistics.add(traced);
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        LivePoint& point = present_.at(chosen[i].x, chosen[i].y);
        point.light = packLight(light_[i]);
        point.lights = visibility_[i];
        point.across = point.down = 0;
        point.age = 0;
        point.flags = static_cast<std::uint8_t>(point.flags | LivePoint::kLit);
    }
    return true;
}

} // namespace rtcore
