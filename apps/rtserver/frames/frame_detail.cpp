#include "rtserver/frames/frame_detail.h"

#include <algorithm>
#include <cmath>

namespace rtserver {

namespace {

constexpr double kLookUp = 0.3;  ///< of the time of a shadow ray
constexpr double kCoarse = 0.25; ///< below, pixels are too large for noise and gloss to be seen as such

int scaled(int pixels, double scale) {
    return std::max(1, static_cast<int>(std::ceil(static_cast<double>(pixels) * scale)));
}

void takeOneSample(rtcore::RenderSettings& settings) {
    settings.antialiasing = 1;
    settings.sampling = rtcore::SamplingPattern::Grid;
    settings.adaptive = 0;
    settings.depthOfField.on = false;
    settings.denoise.passes = 0;
}

// Whatever makes a sample dear or asks for many of them. Light keeps its brightness, so the exposure of the
// whole frame is nearly the same.
void cutSamples(rtcore::RenderSettings& settings, double scale) {
    takeOneSample(settings);
    settings.maxDepth = std::min(settings.maxDepth, 2);
    // Mirrors, but no polished floors.
    settings.minContribution = std::max(settings.minContribution, scale < kCoarse ? 0.3F : 0.1F);
    const int maxRays = scale < kCoarse ? 1 : 4;
    settings.ambientOcclusion.samples = std::min(settings.ambientOcclusion.samples, maxRays);
    settings.skyLight.samples = std::min(settings.skyLight.samples, maxRays);
    settings.areaLights.samples = std::min(settings.areaLights.samples, 1);
    settings.fog.shafts = std::min(settings.fog.shafts, 2);
}

double pixelsOf(const rtcore::RenderSettings& settings) {
    return static_cast<double>(settings.width) * settings.height;
}

} // namespace

rtcore::RenderSettings settingsAt(const rtcore::RenderSettings& settings, const FrameDetail& detail) {
    rtcore::RenderSettings result = settings;
    result.width = scaled(settings.width, detail.scale);
    result.height = scaled(settings.height, detail.scale);
    if (detail.cut) cutSamples(result, detail.scale);
    return result;
}

rtcore::RenderSettings liveSettingsAt(const rtcore::RenderSettings& settings, const rtcore::Scene& scene,
                                      double scale) {
    constexpr double kDear = 100; // rays; with more, too few samples would be traced to show anything
    rtcore::RenderSettings result = settings;
    takeOneSample(result);
    if (workOf(result, scene) > kDear * pixelsOf(result)) cutSamples(result, 1);
    result.width = scaled(settings.width, scale);
    result.height = scaled(settings.height, scale);
    return result;
}

double liveRays(const rtcore::RenderSettings& settings, const rtcore::Scene& scene) {
    const rtcore::RenderSettings live = liveSettingsAt(settings, scene, 1);
    return workOf(live, scene) / pixelsOf(live);
}

double workOf(const rtcore::RenderSettings& settings, const rtcore::Scene& scene, bool mapped) {
    double lights = 0, parts = 0;
    for (const rtcore::SceneLight& each : scene.lights) {
        if (each.light.on == 0) continue;
        ++lights;
        parts += rtcore::isAreaLight(each.light) ? std::max(1, settings.areaLights.samples) : 1;
    }
    const double samples = double{static_cast<float>(settings.antialiasing)} * settings.antialiasing;
    double rays = 1;
    const double shadow = mapped ? kLookUp : 1;
    if (settings.shadows) rays += parts * shadow;
    if (settings.fog.on) rays += lights * settings.fog.shafts * shadow;
    if (settings.indirect.mode == rtcore::IndirectMode::Live) {
        // looked up
    } else if (settings.skyLight.on) {
        rays += settings.skyLight.samples;
    } else if (settings.ambientOcclusion.on) {
        rays += settings.ambientOcclusion.samples;
    }
    if (settings.reflections || settings.refractions) rays *= 1 + 0.25 * settings.maxDepth;
    return pixelsOf(settings) * samples * rays;
}

} // namespace rtserver
