#include "rtcore/render/light_meter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rtcore {

namespace {

constexpr int kWidth = 48, kRoughWidth = 32;
constexpr int kAntialiasing = 3;           ///< each way
constexpr int kPathsOfPixel = 64;          ///< of a pixel
constexpr float kMinMatte = 0.005F;        ///< less says nothing of the light
constexpr float kMinMatteOfShining = 0.1F; ///< less is a light
constexpr float kBrighter = 0.1F;          ///< of the pixels that count
constexpr float kMinPixels = 0.01F;        ///< of all

RenderSettings smallSettings(const RenderSettings& whole, int width) {
    RenderSettings small = whole;
    const double aspect = static_cast<double>(whole.height) / std::max(whole.width, 1);
    small.width = width;
    small.height = std::clamp(static_cast<int>(std::lround(width * aspect)), 1, 4 * width);
    small.antialiasing = kAntialiasing;
    small.sampling = SamplingPattern::Grid;
    small.adaptive = 0;
    small.depthOfField.on = false;
    small.path.samples = kPathsOfPixel;
    small.path.seed = 0;
    small.denoise.net = DenoiseNet::Off; // no effect is measured
    return small;
}

} // namespace

bool LightMeter::findSurfaces(const View& view, RenderControl& control) {
    RenderSettings rays = view.settings;
    rays.integrator = Integrator::Whitted;
    rays.ambientOcclusion.on = rays.skyLight.on = rays.shadows = false;
    rays_.collectAovs(true);
    rays_.lightIndirectlyFrom(nullptr);
    return rays_.render({view.scene, view.tracer, view.camera, rays}, control, surfaces_);
}

/// frame_ has the light, and surfaces_.aovs what it falls on.
bool LightMeter::render(const View& view, RenderControl& control) {
    if (light_ != nullptr && view.settings.integrator == Integrator::Whitted) {
        rays_.collectAovs(true);
        rays_.lightIndirectlyFrom(light_);
        if (!rays_.render(view, control, frame_)) return false;
        std::swap(surfaces_.aovs, frame_.aovs);
        return true;
    }
    ImageRenderer& images = images_.of(view.settings.integrator);
    if (!images.render(view, control, {.aovs = images.rendersAovs()}, frame_)) return false;
    if (!images.rendersAovs()) return findSurfaces(view, control);
    std::swap(surfaces_.aovs, frame_.aovs);
    return true;
}

std::optional<float> LightMeter::white(const View& view, RenderControl& control) {
    const RenderSettings small = smallSettings(view.settings, kWidth);
    return whiteOf({view.scene, view.tracer, view.camera, small}, control);
}

std::optional<float> LightMeter::roughWhite(const View& view, RenderControl& control) {
    RenderSettings small = smallSettings(view.settings, kRoughWidth);
    small.antialiasing = 1;
    small.path.samples = kPathsOfPixel / (kAntialiasing * kAntialiasing);
    return whiteOf({view.scene, view.tracer, view.camera, small}, control);
}

std::optional<float> LightMeter::whiteOf(const View& small, RenderControl& control) {
    RenderControl quietly{.threads = control.threads};
    if (control.cancel || !render(small, quietly) || control.cancel) return std::nullopt;
    if (const auto white = whiteOn(Metered::Lit)) return white;
    return whiteOn(Metered::Shining);
}

std::optional<float> LightMeter::whiteOn(Metered what) {
    const bool shining = what == Metered::Shining;
    const float min = shining ? kMinMatteOfShining : kMinMatte;
    const std::vector<AovPixel>& surfaces = surfaces_.aovs.pixels();
    whites_.clear();
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        if ((surfaces[i].shining > 0) != shining || !(surfaces[i].matte > min)) continue;
        const float white = luminance(frame_.radiance.pixels[i]) / surfaces[i].matte;
        if (std::isfinite(white)) whites_.push_back(white);
    }
    const auto count = static_cast<float>(whites_.size());
    if (count < kMinPixels * static_cast<float>(surfaces.size())) return std::nullopt;
    const auto at = whites_.begin() + static_cast<std::ptrdiff_t>((1 - kBrighter) * (count - 1));
    std::nth_element(whites_.begin(), at, whites_.end());
    if (!(*at > 0)) return std::nullopt;
    return *at;
}

} // namespace rtcore
