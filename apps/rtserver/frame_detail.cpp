#include "rtserver/frame_detail.h"

#include <algorithm>
#include <cmath>

namespace rtserver {

namespace {

int scaled(int pixels, double scale) {
    return std::max(1, static_cast<int>(std::ceil(static_cast<double>(pixels) * scale)));
}

// Whatever makes a sample dear or asks for many of them. Light keeps its brightness, so the exposure of the
// whole frame is nearly the same.
void cutSamples(rtcore::RenderSettings& settings) {
    settings.antialiasing = 1;
    settings.sampling = rtcore::SamplingPattern::Grid;
    settings.adaptive = 0;
    settings.maxDepth = std::min(settings.maxDepth, 2);
    settings.minContribution = std::max(settings.minContribution, 0.1F); // mirrors, but no polished floors
    settings.ambientOcclusion.samples = std::min(settings.ambientOcclusion.samples, 4);
    settings.lampSamples = std::min(settings.lampSamples, 1);
    settings.fog.shafts = std::min(settings.fog.shafts, 2);
    settings.depthOfField.on = false;
    settings.denoise = 0;
}

} // namespace

rtcore::RenderSettings settingsAt(const rtcore::RenderSettings& settings, const FrameDetail& detail) {
    rtcore::RenderSettings result = settings;
    result.width = scaled(settings.width, detail.scale);
    result.height = scaled(settings.height, detail.scale);
    if (detail.cut) cutSamples(result);
    return result;
}

double workOf(const rtcore::RenderSettings& settings, const rtcore::Scene& scene) {
    const double lights = static_cast<double>(std::count_if(
        scene.lights.begin(), scene.lights.end(), [](const rtcore::Light& l) { return l.on != 0; }));
    const double samples = double{static_cast<float>(settings.antialiasing)} * settings.antialiasing;
    double rays = 1;
    if (settings.shadows) rays += lights * std::max(1, settings.lampSamples);
    if (settings.fog.on) rays += lights * settings.fog.shafts;
    if (settings.ambientOcclusion.on) rays += settings.ambientOcclusion.samples;
    if (settings.reflections || settings.refractions) rays *= 1 + 0.25 * settings.maxDepth;
    return static_cast<double>(settings.width) * settings.height * samples * rays;
}

} // namespace rtserver
