#include "rtcore/post/tone_map_block.h"

#include "rtcore/post/quantise.h"

#include <bit>
#include <cstdint>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/post/tone_map_block.cpp"
#define HWY_DISABLED_TARGETS HWY_SSSE3
#include <hwy/foreach_target.h>
// The loop over targets comes before the code that is compiled for each of them.
#include "rtcore/shading/vector_math-inl.h"

#ifndef RTCORE_POST_TONE_MAP_TYPES
#define RTCORE_POST_TONE_MAP_TYPES
namespace rtcore {

/// A block of pixels between the two halves of its way.
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

HWY_INLINE Floats sigmoids(Floats y, Floats c) {
    const Floats mapped = hn::Div(constant(1), hn::Add(constant(1), hn::Div(c, y)));
    return hn::IfThenElseZero(hn::Gt(y, constant(0)), mapped);
}

HWY_INLINE Lanes isFiniteAll(Vectors x) {
    const FloatTag d;
    const Floats infinity = hn::BitCast(d, hn::Set(BitsTag(), 0x7F800000U));
    return hn::And(hn::And(hn::Lt(hn::Abs(x.x), infinity), hn::Lt(hn::Abs(x.y), infinity)),
                   hn::Lt(hn::Abs(x.z), infinity));
}

HWY_INLINE Vectors mapLuminance(Vectors x, Floats c) {
    const FloatTag d;
    const Floats y = dot(constant(0.2126F, 0.7152F, 0.0722F), x);
    const Floats l = sigmoids(y, c);
    const Vectors grey{l, l, l};
    const Lanes shown = hn::Gt(l, constant(0));
    const Lanes ordinary = hn::And(isFiniteAll(x), hn::Lt(y, constant(1e30F)));
    Vectors mapped = x / hn::Add(y, c);
    const Floats largest = larger(mapped.x, larger(mapped.y, mapped.z));
    const Lanes tooBright = hn::Gt(largest, constant(1));
    if (!hn::AllFalse(d, hn::And(shown, tooBright))) {
        const Floats blend = hn::Div(hn::Sub(constant(1), l), hn::Sub(largest, l));
        mapped = select(tooBright, grey * hn::Sub(constant(1), blend) + mapped * blend, mapped);
    }
    return selectOrZero(shown, select(ordinary, mapped, grey));
}

/// x where the sRGB curve is taken from its table.
HWY_INLINE Lanes isOnChord(Floats x) {
    return hn::And(hn::Gt(x, constant(0x1p-13F)), hn::Lt(x, constant(1)));
}

HWY_INLINE Bits chordOf(Floats x) {
    const BitsTag du;
    const Bits bits = hn::BitCast(du, hn::IfThenElse(isOnChord(x), x, constant(0.5F)));
    return hn::Sub(hn::ShiftRight<SrgbCurve::kShift>(bits), hn::Set(du, SrgbCurve::kFirst));
}

/// SrgbCurve::code(), with the chord of each x.
HWY_INLINE Floats srgbCodes(Floats x, const SrgbCurve::Chord* HWY_RESTRICT chords) {
    const FloatTag d;
    const BitsTag du;
    const hn::RebindToSigned<FloatTag> di;
    Floats code, rise;
    hn::LoadInterleaved2(d, &chords->code, code, rise);
    constexpr std::uint32_t kMask = (std::uint32_t{1} << SrgbCurve::kShift) - 1;
    const Floats rest = hn::ConvertTo(d, hn::BitCast(di, hn::And(hn::BitCast(du, x), hn::Set(du, kMask))));
    const Floats share =
        hn::Mul(rest, constant(1.0F / static_cast<float>(kMask + 1))); // a power of two: exact
    const Floats curved = hn::Add(code, hn::Mul(rise, share));
    const Floats linear = hn::IfThenElseZero(hn::Gt(x, constant(0)), hn::Mul(constant(255 * 12.92F), x));
    const Floats outside = hn::IfThenElse(hn::Ge(x, constant(1)), constant(255), linear);
    return hn::IfThenElse(isOnChord(x), curved, outside);
}

/// ditherThreshold()
HWY_INLINE Floats ditherThresholds(Floats x, float y) {
    const Floats inner = hn::Add(hn::Mul(constant(0.06711056F), x), constant(0.00583715F * y));
    const Floats outer = hn::Mul(constant(52.9829189F), hn::Sub(inner, hn::Floor(inner)));
    const Floats threshold = hn::Sub(outer, hn::Floor(outer));
    return hn::IfThenElseZero(hn::Lt(threshold, constant(1)), threshold);
}

/// quantise()
HWY_INLINE Bits quantiseAll(Floats code, Floats threshold) {
    const hn::RebindToSigned<FloatTag> di;
    const Floats value = hn::Add(code, threshold);
    const Floats kept = hn::IfThenElse(hn::Ge(value, constant(255)), constant(255),
                                       hn::IfThenElseZero(hn::Gt(value, constant(0)), value));
    return hn::BitCast(BitsTag(), hn::ConvertTo(di, kept));
}

/// First half: what is shown of each pixel, and its chords of the sRGB curve.
void mapBlock(const Development& how, const float* HWY_RESTRICT radiance, ToneBlock& block) {
    const FloatTag d;
    const BitsTag du;
    const Floats c = constant(how.exposure > 1e-30F ? how.exposure : 1e-30F);
    for (std::size_t i = 0; i < kToneBlock; i += hn::Lanes(d)) {
        Vectors x;
        hn::LoadInterleaved3(d, radiance + 3 * i, x.x, x.y, x.z);
        const Vectors shown = how.toneMapping == ToneMapping::Luminance
                                  ? mapLuminance(x, c)
                                  : Vectors{sigmoids(x.x, c), sigmoids(x.y, c), sigmoids(x.z, c)};
        storeVectors(shown, block.shown[0] + i, block.shown[1] + i, block.shown[2] + i);
        hn::StoreU(chordOf(shown.x), du, block.index[0] + i);
        hn::StoreU(chordOf(shown.y), du, block.index[1] + i);
        hn::StoreU(chordOf(shown.z), du, block.index[2] + i);
    }
}

/// Second half, with the chords fetched.
void quantiseBlock(const Development& how, const ToneBlock& block, int column, int row,
                   std::uint32_t* HWY_RESTRICT pixels) {
    const FloatTag d;
    const BitsTag du;
    const hn::RebindToSigned<FloatTag> di;
    const auto lane = hn::Iota(di, 0);
    for (std::size_t i = 0; i < kToneBlock; i += hn::Lanes(d)) {
        Floats threshold = constant(0.5F);
        if (how.dithering) {
            const Floats columns = hn::ConvertTo(d, hn::Add(lane, hn::Set(di, column + static_cast<int>(i))));
            threshold = ditherThresholds(columns, static_cast<float>(row));
        }
        const auto quantised = [&](std::size_t channel) {
            const Floats shown = hn::LoadU(d, block.shown[channel] + i);
            return quantiseAll(srgbCodes(shown, block.chords[channel] + i), threshold);
        };
        const Bits rgb =
            hn::Or(hn::Or(quantised(0), hn::ShiftLeft<8>(quantised(1))), hn::ShiftLeft<16>(quantised(2)));
        hn::StoreU(hn::Or(rgb, hn::Set(du, 0xFF000000U)), du, pixels + i);
    }
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(mapBlock);
HWY_EXPORT(quantiseBlock);

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
