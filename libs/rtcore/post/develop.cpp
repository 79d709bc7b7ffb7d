#include "rtcore/post/develop.h"

#include "rtcore/post/exposure.h"
#include "rtcore/post/quantise.h"
#include "rtcore/post/tone_map.h"

#include <algorithm>
#include <vector>

namespace rtcore {

namespace {

constexpr float kRounding = 0.5F;
/// The exposure of a picture that is black all over.
constexpr float kDarkness = 1;
/// What a fixed exposure may be (settings_table.cpp), so that any automatic one can be written down and
/// replayed.
constexpr float kLeast = 1e-30F;
constexpr float kMost = 1e30F;

} // namespace

float exposureFor(const Frame& frame, const ExposureSettings& settings) {
    if (settings.mode == ExposureMode::Fixed) return settings.value;
    auto average = logAverageLuminance(frame.radiance.pixels, frame.covered);
    if (!average) {
        // Nothing but background: then that is what the eye adapts to.
        const std::vector<std::uint8_t> all(frame.covered.size(), 255);
        average = logAverageLuminance(frame.radiance.pixels, all);
    }
    return std::clamp(average.value_or(kDarkness) / settings.key, kLeast, kMost);
}

LdrImage develop(const Frame& frame, const RenderSettings& settings, float exposure) {
    static const SrgbCurve curve;
    const HdrImage& radiance = frame.radiance;
    LdrImage image(radiance.width, radiance.height);
#pragma omp parallel for schedule(static)
    for (int y = 0; y < radiance.height; ++y) {
        for (int x = 0; x < radiance.width; ++x) {
            const Colour c = radiance.at(x, y);
            const Colour shown = settings.toneMapping == ToneMapping::Luminance
                                     ? toneMapLuminance(c, exposure)
                                     : toneMapChannels(c, exposure);
            const float t = settings.dithering ? ditherThreshold(x, y) : kRounding;
            image.at(x, y) = {quantise(curve.code(shown.r), t), quantise(curve.code(shown.g), t),
                              quantise(curve.code(shown.b), t), 255};
        }
    }
    return image;
}

} // namespace rtcore
