#include "rtcore/post/tone_map_block.h"

#include <bit>
#include <cstdint>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/post/tone_map_block.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/post/tone_map-inl.h"
#include "rtcore/simd/portable_math.h"

#ifndef RTCORE_POST_TONE_MAP_TYPES
#define RTCORE_POST_TONE_MAP_TYPES
namespace rtcore {

/// A block of pixels between the two halves of its processing.
struct ToneBlock {
    alignas(64) float shown[3][kToneBlock];
    alignas(64) std::uint32_t index[3][kToneBlock];
    alignas(64) SrgbCurve::Chord chords[3][kToneBlock];
};

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// First half: what is shown of each pixel by `curve`, and its chords of the sRGB curve.
template <typename Curve>
HWY_INLINE void mapBlockBy(const float* radiance, ToneBlock& block, Curve&& curve) {
    for (std::size_t i = 0; i < kToneBlock; i += lanes()) {
        const Float3 shown = curve(loadInterleaved(radiance + 3 * i));
        store(shown, block.shown[0] + i, block.shown[1] + i, block.shown[2] + i);
        store(chordOf(shown.x), block.index[0] + i);
        store(chordOf(shown.y), block.index[1] + i);
        store(chordOf(shown.z), block.index[2] + i);
    }
}
void mapBlock(const Development& how, const float* radiance, ToneBlock& block) {
    const float constant = how.exposure > 1e-30F ? how.exposure : 1e-30F;
    const Float c = constant, scale = 1 / constant;
    switch (how.toneMapping) {
    case ToneMapping::Luminance:
        return mapBlockBy(radiance, block, [&](Float3 x) HWY_ATTR { return toneMapLuminance<Float>(x, c); });
    case ToneMapping::Channels:
        return mapBlockBy(radiance, block, [&](Float3 x) HWY_ATTR { return toneMapChannels<Float>(x, c); });
    case ToneMapping::AgX:
        return mapBlockBy(radiance, block,
                          [&](Float3 x) HWY_ATTR { return toneMapAgx(x * scale, how.contrast); });
    case ToneMapping::Neutral:
        return mapBlockBy(radiance, block,
                          [&](Float3 x) HWY_ATTR { return toneMapNeutral<Float>(x * scale); });
    }
}

/// Four bytes of a pixel, opaque.
HWY_INLINE void storePixels(Int red, Int green, Int blue, std::uint32_t* pixels) {
    store(toUint(red) | shiftLeft<8>(toUint(green)) | shiftLeft<16>(toUint(blue)) | 0xFF000000U, pixels);
}

/// Second half, with the chords fetched.
void quantiseBlock(const Development& how, const ToneBlock& block, int column, int row,
                   std::uint32_t* pixels) {
    for (std::size_t i = 0; i < kToneBlock; i += lanes()) {
        Float threshold = 0.5F;
        if (how.dithering) {
            const Int columns = toInt(iota(static_cast<std::size_t>(column) + i));
            threshold = ditherThreshold(toFloat(columns), static_cast<float>(row));
        }
        const auto shown = [&](std::size_t channel) HWY_ATTR { return load(block.shown[channel] + i); };
        const auto quantised = [&](std::size_t channel, auto&& codeOf) HWY_ATTR {
            Float code, rise;
            hn::LoadInterleaved2(FloatTag(), &block.chords[channel][i].code, code.raw, rise.raw);
            return codeOf(shown(channel), code, rise);
        };
        const auto onChord = [&](Float x, Float code, Float rise)
                                 HWY_ATTR { return quantisePositive(codeOnChord(x, code, rise), threshold); };
        const auto anywhere = [&](Float x, Float code, Float rise)
                                  HWY_ATTR { return quantise(srgbCode(x, code, rise), threshold); };
        if (all(isOnChord(shown(0)) & isOnChord(shown(1)) & isOnChord(shown(2)))) {
            storePixels(quantised(0, onChord), quantised(1, onChord), quantised(2, onChord), pixels + i);
        } else {
            storePixels(quantised(0, anywhere), quantised(1, anywhere), quantised(2, anywhere), pixels + i);
        }
    }
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(mapBlock);
HWY_EXPORT(quantiseBlock);

float exposureOfWhite(const Development& how, float white) {
    constexpr float kShown = 0.8387990F; // the linear light of 236 of 255
    return exposureShowing(how, white, kShown);
}

float exposureShowing(const Development& how, float radiance, float shown) {
    // Greys between two bounds, three times, each time between two neighbours: within 6e-5.
    Development one = how;
    one.exposure = 1;
    float low = 1.0F / 4096, high = 64;
    for (int round = 0; round < 3; ++round) {
        Colour greys[kToneBlock];
        const float octaves = portableLog2(high / low);
        for (std::size_t i = 0; i < kToneBlock; ++i)
            greys[i] = kWhite * (low * portableExp2(octaves * static_cast<float>(i) / (kToneBlock - 1)));
        ToneBlock block;
        HWY_DYNAMIC_DISPATCH(mapBlock)(one, &greys[0].r, block);
        std::size_t above = 1;
        while (above + 1 < kToneBlock && block.shown[1][above] < shown) ++above;
        low = greys[above - 1].g;
        high = greys[above].g;
    }
    return radiance / high;
}

void developBlock(const Development& how, const Colour* radiance, int x, int y, Rgba8* pixels) {
    static_assert(std::endian::native == std::endian::little); // red is the lowest byte
    static const SrgbCurve curve;
    ToneBlock block;
    HWY_DYNAMIC_DISPATCH(mapBlock)(how, &radiance->r, block);
    const SrgbCurve::Chord* const chords = curve.chords();
    for (std::size_t channel = 0; channel < 3; ++channel) {
        // One by one: gathering in vector code takes twice as long.
        for (std::size_t i = 0; i < kToneBlock; ++i) {
            block.chords[channel][i] = chords[block.index[channel][i]];
        }
    }
    std::uint32_t packed[kToneBlock];
    HWY_DYNAMIC_DISPATCH(quantiseBlock)(how, block, x, y, packed);
    std::memcpy(pixels, packed, sizeof packed);
}

} // namespace rtcore
#endif
