#include "rtcore/render/refinement.h"

namespace rtcore {

namespace {

constexpr int kCoarsest = 8;
/// Time for the passes before the image, over that of the image itself.
constexpr double kFraction = 0.095;

/// About the time for each pixel, in that of an image with one sample per pixel. Rays that are further apart
/// share less of their way, and each image is shown; measured on the inside of a church.
double cost(const RefinementPass& pass) {
    constexpr double kShown = 0.06;
    switch (pass.block) {
    case 8:
        return 3.5 / 64 + kShown;
    case 4:
        return 2.0 / 16 + kShown;
    case 2:
        return 1.4 / 4 + kShown;
    default:
        const double samples = static_cast<double>(pass.antialiasing) * pass.antialiasing;
        return samples > 1 ? 0.8 * samples : 1;
    }
}

RefinementPass finer(const RefinementPass& pass) {
    if (pass.block > 1) return {pass.block / 2, 1};
    return {1, pass.antialiasing * 2};
}

} // namespace

std::vector<RefinementPass> planRefinement(const RenderSettings& settings) {
    const RefinementPass picture{1, settings.antialiasing};
    double left = kFraction * cost(picture);
    std::vector<RefinementPass> plan;
    for (RefinementPass pass{kCoarsest, 1}; plan.empty() || cost(pass) <= left; pass = finer(pass)) {
        left -= cost(pass);
        plan.push_back(pass);
    }
    plan.push_back(picture);
    return plan;
}

bool Refinement::render(FrameRenderer& renderer, const View& view, RenderControl& control, Frame& frame,
                        const Show& show) {
    const std::vector<RefinementPass> plan = planRefinement(view.settings);
    double all = 0;
    for (const RefinementPass& pass : plan) all += cost(pass);
    before_ = fraction_ = 0;
    finished_.clear();
    for (const RefinementPass& pass : plan) {
        const bool last = &pass == &plan.back();
        enter(cost(pass) / all, control);
        control.finished = last ? &finished_ : nullptr;
        Frame& picture = last ? frame : frame_;
        RenderSettings quality = view.settings;
        quality.antialiasing = pass.antialiasing;
        const View seen{view.scene, view.tracer, view.camera, quality};
        const bool whole = pass.block > 1 ? renderer.renderCoarse(seen, pass.block, control, picture)
                                          : renderer.render(seen, control, picture);
        control.finished = nullptr;
        if (!whole) return false;
        if (!last) show(pass, picture);
    }
    return true;
}

void Refinement::enter(double fraction, RenderControl& control) {
    const std::lock_guard lock(mutex_);
    control.tiles = 0;
    before_ += fraction_;
    fraction_ = fraction;
}

double Refinement::fraction(const RenderControl& control) const {
    const std::lock_guard lock(mutex_);
    const std::uint64_t tiles = control.tiles.load();
    const double done =
        tiles == 0 ? 0.0 : static_cast<double>(control.tilesDone.load()) / static_cast<double>(tiles);
    return before_ + done * fraction_;
}

} // namespace rtcore
