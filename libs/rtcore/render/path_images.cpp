#include "rtcore/render/path_images.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace rtcore {

namespace {

/// Times, in those of one sample of each pixel.
constexpr double kTimeOfGuides = 2, kTimeOfSteady = 8, kTimeOfAovs = 4;
/// Pixels a side of the squares of the first image that is shown.
constexpr int kCoarse = 2;
/// Samples of each pixel from which on all rays of the guides are worth their time.
constexpr std::uint32_t kManySamples = 2;

} // namespace

bool PathImages::render(const View& view, RenderControl& control, const ImageRequest& request, Frame& frame) {
    const double steady = mixesSteadyImage(view.settings) ? kTimeOfSteady : 0,
                 guides = request.guides ? kTimeOfGuides : 0, samples = view.settings.path.samples,
                 aovs = request.aovs ? kTimeOfAovs : 0, all = guides + samples + steady + aovs;
    enter({0, 0}, control);
    frame.guides = {};
    frame.steady = {};
    paths_.treatBackground(request.background);
    if (request.show && denoisesByNet(view.settings) && !showCoarse(view, control, request)) return false;
    enter({0, guides / all}, control);
    const GuideRays rays = request.show ? GuideRays::Few : GuideRays::All;
    if (request.guides && !findGuides(view, control, rays, frame)) return false;
    enter({guides / all, samples / all}, control);
    if (!renderPaths(view, control, request, frame)) return false;
    enter({(guides + samples) / all, steady / all}, control);
    if (!findSteady(view, control, frame)) return false;
    enter({(guides + samples + steady) / all, aovs / all}, control);
    if (!request.aovs) return true;
    constexpr int kSamples = 4; // each way: edges are as smooth as those of the image
    if (!findSurfaces(view, control, kSamples)) return false;
    std::swap(frame.aovs, surfaces_.aovs);
    return true;
}

/// What the image is mixed with, unless the frame has it already, or it is mixed with none. The control
/// counts on afterwards from where it was.
bool PathImages::findSteady(const View& view, RenderControl& control, Frame& frame) {
    if (!mixesSteadyImage(view.settings) || !frame.steady.empty()) return true;
    const auto exchange = [this](std::unique_ptr<SteadyImage> other) {
        const std::lock_guard lock(mutex_);
        std::swap(steady_, other);
        return other;
    };
    const std::uint64_t tiles = control.tiles, done = control.tilesDone;
    exchange(std::make_unique<SteadyImage>());
    steady_->beginWith(kept_);
    const bool whole = steady_->render(view, control, frame);
    exchange(nullptr); // its memory goes, without the lock
    control.tilesDone = done;
    control.tiles = tiles;
    return whole;
}

/// The same among samples that are shown.
bool PathImages::findSteadyMeanwhile(const View& view, RenderControl& control, Frame& frame) {
    const Span own = span();
    setSpan({fraction(control), 0});
    const bool whole = findSteady(view, control, frame);
    setSpan(own);
    return whole;
}

/// A net makes a quarter of the pixels, soon, better than all of them later.
bool PathImages::showCoarse(const View& view, RenderControl& control, const ImageRequest& request) {
    if (!rays_.renderGuides(view, kCoarse, GuideRays::Few, control, coarse_.guides)) return false;
    if (!paths_.renderCoarse(view, kCoarse, control, coarse_)) return false;
    request.show({coarse_, kCoarse, 1, nullptr, &coarse_.guides});
    return !control.cancel;
}

bool PathImages::renderPaths(const View& view, RenderControl& control, const ImageRequest& request,
                             Frame& frame) {
    PathRenderer::Show show;
    if (request.show) {
        const bool filtered = !denoisesByNet(view.settings);
        if (filtered) {
            const Span own = span();
            enter({own.before, 0}, control);
            if (!findSurfaces(view, control, 1)) return false;
            enter(own, control);
        }
        show = [&, filtered](std::uint32_t samples, const Frame& picture) {
            if (request.guides && samples >= kManySamples &&
                !findGuides(view, control, GuideRays::All, frame)) {
                return;
            }
            if (samples >= kTimeOfSteady && !findSteadyMeanwhile(view, control, frame)) return;
            request.show({picture, 1, samples, filtered ? &surfaces_.aovs : nullptr,
                          request.guides ? &frame.guides : nullptr});
        };
    }
    return paths_.render(view, control, frame, show) &&
           (!request.guides || findGuides(view, control, GuideRays::All, frame));
}

/// Guides of so many rays, unless the frame has them already. The control counts on afterwards from where it
/// was.
bool PathImages::findGuides(const View& view, RenderControl& control, GuideRays rays, Frame& frame) {
    if (!frame.guides.empty() && guideRays_ == rays) return true;
    const Span own = span();
    const std::uint64_t tiles = control.tiles, done = control.tilesDone;
    if (!frame.guides.empty()) setSpan({fraction(control), 0});
    const bool whole = rays_.renderGuides(view, 1, rays, control, frame.guides);
    guideRays_ = rays;
    control.tilesDone = done;
    control.tiles = tiles;
    setSpan(own);
    return whole;
}

/// AOVs of paths are those of rays, which see the same first.
bool PathImages::findSurfaces(const View& view, RenderControl& control, int samples) {
    RenderSettings rays = view.settings;
    rays.integrator = Integrator::Whitted;
    rays.antialiasing = samples;
    rays.adaptive = 0;
    rays.ambientOcclusion.on = rays.skyLight.on = false;
    rays_.collectAovs(true);
    return rays_.render({view.scene, view.tracer, view.camera, rays}, control, surfaces_);
}

/// Begins work that the control counts from 0.
void PathImages::enter(const Span& span, RenderControl& control) {
    control.tilesDone = 0;
    setSpan(span);
}

void PathImages::setSpan(const Span& span) {
    const std::lock_guard lock(mutex_);
    span_ = span;
}

PathImages::Span PathImages::span() const {
    const std::lock_guard lock(mutex_);
    return span_;
}

double PathImages::fraction(const RenderControl& control) const {
    const std::lock_guard lock(mutex_);
    const double done = steady_ != nullptr ? steady_->fraction(control) : control.fraction();
    return span_.before + span_.size * std::min(done, 1.0);
}

/// Tells which samples were lost, and which lights the paths sample.
std::vector<ImageRemark> PathImages::remarks() const {
    std::vector<ImageRemark> remarks;
    const std::uint64_t dropped = paths_.sums().dropped(), clipped = paths_.sums().clipped();
    if (dropped > 0) {
        remarks.push_back(
            {say("warning: {0}", say("{0} samples were not finite and do not count; the scene has "
                                     "numbers that are too large",
                                     dropped)),
             false, false});
    }
    if (clipped > 0) {
        remarks.push_back(
            {say("{0} samples are brighter than {1} and count as that: the image has less light "
                 "than the scene",
                 clipped, fmt::format("{:.3g}", paths_.sums().largest())),
             true, false});
    }
    const LightSet& lights = paths_.lights();
    const bool alone = lights.surroundings().empty();
    remarks.push_back(
        {say(alone ? "paths are lit by {0} lights, {1} emissive triangles"
                   : "paths are lit by {0} lights, {1} emissive triangles, and the surroundings",
             lights.lights().size(), lights.emitters().size()),
         true, true});
    for (std::size_t i = 0; i < lights.emitsNoLight().size(); ++i) {
        if (lights.emitsNoLight()[i] == 0) continue;
        remarks.push_back({say("material {0} is seen to emit light, but lights nothing", i), true, true});
    }
    return remarks;
}

} // namespace rtcore
