/// Tone mapping and quantisation of many pixels at once; the bits are those of tone_map-inl.h and quantise.h.
#pragma once

#include "rtcore/scene/image.h"
#include "rtcore/settings/render_settings.h"

#include <cstddef>

namespace rtcore {

inline constexpr std::size_t kToneBlock = 64;

struct FalseColours;

struct Development {
    ToneMapping toneMapping = ToneMapping::Luminance;
    bool dithering = true;
    float contrast = 0; ///< RenderSettings::toneContrast
    float exposure = 1; ///< the constant c of L = Y / (Y + c); the other curves get Y / c
    const FalseColours* falseColours = nullptr; ///< in place of all that (developPart()); null: none
};
inline Development developmentOf(const RenderSettings& settings, float exposure) {
    return {.toneMapping = settings.toneMapping,
            .dithering = settings.dithering,
            .contrast = settings.toneContrast,
            .exposure = exposure};
}

/// The exposure by which a grey of radiance `white` is shown as 236 of 255.
float exposureOfWhite(const Development& how, float white);
/// The exposure by which a grey of that radiance is shown as `shown`, linear light 0..1, of what the curve
/// makes of greys of 1/4096 to 64 times the exposure.
float exposureShowing(const Development& how, float radiance, float shown);

/// kToneBlock pixels of row `y` from column `x` on.
void developBlock(const Development& how, const Colour* radiance, int x, int y, Rgba8* pixels);

} // namespace rtcore
