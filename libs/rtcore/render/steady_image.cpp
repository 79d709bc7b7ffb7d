#include "rtcore/render/steady_image.h"

#include <algorithm>
#include <utility>

namespace rtcore {

namespace {

constexpr int kSamplesAcross = 4; ///< samples of a pixel, each way: edges of few are worse than a net's

} // namespace

RenderSettings steadySettings(const RenderSettings& settings) {
    RenderSettings rays = settings;
    rays.integrator = Integrator::Whitted;
    rays.path.seed = 0; // of the paths that records learn from
    rays.antialiasing = std::max(kSamplesAcross, settings.antialiasing);
    return rays;
}

bool SteadyImage::render(const View& view, RenderControl& control, Frame& frame) {
    const RenderSettings settings = steadySettings(view.settings);
    ImageRequest request;
    if (!frame.transmitted.empty()) request.background = Background::Hidden;
    Frame image;
    if (!rays_.render({view.scene, view.tracer, view.camera, settings}, control, request, image))
        return false;
    frame.steady = std::move(image.radiance);
    return !control.cancel;
}

} // namespace rtcore
