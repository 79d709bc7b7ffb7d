#include "rtcore/post/tone_map_block.h"

#include "rtcore/post/quantise.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/post/tone_map_block.cpp"
#define HWY_DISABLED_TARGETS HWY_SSSE3
#include <hwy/foreach_target.h>
// The loop over targets comes before the code that is compiled for each of them.
#include "rtcore/shading/vector_math-inl.h"

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

/// SrgbCurve::code()
HWY_INLINE Floats srgbCodes(const float* HWY_RESTRICT codes, Floats x) {
    const FloatTag d;
    const BitsTag du;
    const hn::RebindToSigned<FloatTag> di;
    const Lanes onChord = hn::And(hn::Gt(x, constant(0x1p-13F)), hn::Lt(x, constant(1)));
    const Bits bits = hn::BitCast(du, hn::IfThenElse(onChord, x, constant(0.5F)));
    const auto chord = hn::BitCast(
        di, hn::Sub(hn::ShiftRight<SrgbCurve::kShift>(bits), hn::Set(du, SrgbCurve::kFirst)));
    constexpr std::uint32_t kMask = (std::uint32_t{1} << SrgbCurve::kShift) - 1;
    const Floats rest = hn::ConvertTo(d, hn::BitCast(di, hn::And(bits, hn::Set(du, kMask))));
    const Floats share = hn::Mul(rest, constant(1.0F / static_cast<float>(kMask + 1))); // a power of two: exact
    const Floats from = hn::GatherIndex(d, codes, chord);
    const Floats to = hn::GatherIndex(d, codes + 1, chord);
    const Floats curved = hn::Add(from, hn::Mul(hn::Sub(to, from), share));
    const Floats linear =
        hn::IfThenElseZero(hn::Gt(x, constant(0)), hn::Mul(constant(255 * 12.92F), x));
    return hn::IfThenElse(onChord, curved, hn::IfThenElse(hn::Ge(x, constant(1)), constant(255), linear));
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

void developAll(const Development& how, const float* HWY_RESTRICT codes, const float* HWY_RESTRICT radiance,
                int column, int row, std::uint32_t* HWY_RESTRICT pixels) {
    const FloatTag d;
    const BitsTag du;
    const hn::RebindToSigned<FloatTag> di;
    const Floats c = constant(std::max(how.exposure, 1e-30F));
    for (std::size_t i = 0; i < kToneBlock; i += hn::Lanes(d)) {
        Vectors x;
        hn::LoadInterleaved3(d, radiance + 3 * i, x.x, x.y, x.z);
        const Vectors shown = how.toneMapping == ToneMapping::Luminance
                                  ? mapLuminance(x, c)
                                  : Vectors{sigmoids(x.x, c), sigmoids(x.y, c), sigmoids(x.z, c)};
        Floats threshold = constant(0.5F);
        if (how.dithering) {
            const Floats columns = hn::ConvertTo(d, hn::Iota(di, column + static_cast<int>(i)));
            threshold = ditherThresholds(columns, static_cast<float>(row));
        }
        const Bits r = quantiseAll(srgbCodes(codes, shown.x), threshold);
        const Bits g = quantiseAll(srgbCodes(codes, shown.y), threshold);
        const Bits b = quantiseAll(srgbCodes(codes, shown.z), threshold);
        const Bits rgb = hn::Or(hn::Or(r, hn::ShiftLeft<8>(g)), hn::ShiftLeft<16>(b));
        hn::StoreU(hn::Or(rgb, hn::Set(du, 0xFF000000U)), du, pixels + i);
    }
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(developAll);

void developBlock(const Development& how, const Colour* radiance, int x, int y, Rgba8* pixels) {
    static_assert(std::endian::native == std::endian::little); // red is the lowest byte
    static const SrgbCurve curve;
    std::uint32_t packed[kToneBlock];
    HWY_DYNAMIC_DISPATCH(developAll)(how, curve.codes(), &radiance->r, x, y, packed);
    std::memcpy(pixels, packed, sizeof packed);
}

} // namespace rtcore
#endif
