#include "rtcore/render/ray_images.h"

namespace rtcore {

namespace {

/// Of the time that an image takes, about.
double learningPartOf(const RenderSettings& settings) {
    constexpr double kSamples = 6; // of each pixel, which take as long
    const double samples = double{static_cast<float>(settings.antialiasing)} * settings.antialiasing;
    return kSamples / (kSamples + samples);
}

} // namespace

bool RayImages::render(const View& view, RenderControl& control, const ImageRequest& request, Frame& frame) {
    renderer_.collectAovs(request.aovs);
    renderer_.treatBackground(request.background);
    refines_ = false;
    const bool done = learnAndRender(view, control, request, frame);
    learningPart_ = 0; // nothing is learned until the next image
    return done;
}

bool RayImages::learnAndRender(const View& view, RenderControl& control, const ImageRequest& request,
                               Frame& frame) {
    const bool indirect = view.settings.indirect.mode == IndirectMode::Live;
    learningPart_ = indirect ? learningPartOf(view.settings) : 0;
    if (indirect && !learn(view, control)) return false;
    renderer_.lightIndirectlyFrom(indirect ? &light_.light() : nullptr);
    refines_ = static_cast<bool>(request.show);
    if (!refines_) return renderer_.render(view, control, frame);
    return refinement_.render(
        renderer_, view, control, frame, [&](const RefinementPass& pass, const Frame& picture) {
            const int samples = pass.antialiasing * pass.antialiasing;
            request.show({picture, pass.block, static_cast<std::uint32_t>(samples), nullptr, nullptr});
        });
}

bool RayImages::learn(const View& view, RenderControl& control) {
    learns_ = true;
    const bool done = light_.learn(view, control);
    control.tiles = control.tilesDone = 0; // those of its images
    learns_ = false;
    return done;
}

double RayImages::fraction(const RenderControl& control) const {
    if (learns_) return learningPart_ * light_.fraction();
    const double rendered = refines_ ? refinement_.fraction(control) : control.fraction();
    return learningPart_ + (1 - learningPart_) * rendered;
}

} // namespace rtcore
