#include "renderer/exposure_scale.h"

#include "rtcore/platform/error.h"

#include <algorithm>
#include <cmath>

namespace renderer {

namespace {

constexpr int kWidth = 64;
constexpr int kSamples = 64;     ///< paths of a pixel: 147,000 of an image of 16:9
constexpr int kAntialiasing = 2; ///< each way

rtcore::RenderSettings smallSettings(const rtcore::RenderSettings& whole, rtcore::Integrator integrator) {
    rtcore::RenderSettings small = whole;
    small.width = kWidth;
    small.height =
        std::clamp(static_cast<int>(std::lround(kWidth * static_cast<double>(whole.height) / whole.width)), 1,
                   2 * kWidth);
    small.integrator = integrator;
    small.path.samples = kSamples;
    small.antialiasing = kAntialiasing;
    small.adaptive = 0;
    small.denoise.net = rtcore::DenoiseNet::Off; // no effect is measured
    return small;
}

/// `view` has the settings of a small image.
void render(const rtcore::View& view, rtcore::RenderControl& control, rtcore::ImageRenderers& images,
            rtcore::Frame& frame) {
    if (!images.of(view.settings.integrator).render(view, control, {}, frame))
        throw rtcore::FileError(rtcore::FailureKind::Stopped, "", "stopped");
}

/// In the order of the pixels, so that the bits are always the same.
double meanLuminance(const rtcore::HdrImage& image) {
    double sum = 0;
    for (const rtcore::Colour& pixel : image.pixels) {
        const double seen = rtcore::luminance(pixel);
        if (std::isfinite(seen)) sum += seen;
    }
    return sum / static_cast<double>(std::max<std::size_t>(image.pixels.size(), 1));
}

} // namespace

bool saysExposure(std::span<const rtcore::SettingAssignment> commandLine) {
    return std::any_of(commandLine.begin(), commandLine.end(), [](const auto& each) {
        return each.name == "exposure.mode" || each.name == "exposure.value";
    });
}

bool hasRecordedExposure(const rtcore::CameraFile& camera,
                         std::span<const rtcore::SettingAssignment> commandLine) {
    return camera.exposure && !saysExposure(commandLine);
}

void renderSmall(const rtcore::View& view, rtcore::RenderControl& control, rtcore::ImageRenderers& images,
                 rtcore::Frame& frame) {
    const rtcore::RenderSettings small = smallSettings(view.settings, view.settings.integrator);
    render({view.scene, view.tracer, view.camera, small}, control, images, frame);
}

rtcore::ValueScale valueScaleOf(const rtcore::View& view, const rtcore::LuminanceUnit& unit,
                                rtcore::RenderControl& control, rtcore::ImageRenderers& images) {
    rtcore::Frame frame;
    renderSmall(view, control, images, frame);
    return rtcore::ScaleChoice().choose(frame.radiance, view.settings.falseColours, unit, false);
}

float exposureScale(const rtcore::View& view, rtcore::RenderControl& control,
                    rtcore::ImageRenderers& images) {
    rtcore::Frame frame;
    const auto mean = [&](rtcore::Integrator integrator) {
        const rtcore::RenderSettings small = smallSettings(view.settings, integrator);
        render({view.scene, view.tracer, view.camera, small}, control, images, frame);
        return meanLuminance(frame.radiance);
    };
    const double straight = mean(rtcore::Integrator::Whitted);
    const double all = mean(view.settings.integrator);
    return straight > 0 && all > 0 ? static_cast<float>(all / straight) : 1.0F;
}

} // namespace renderer
