// From radiance to codes of sRGB, over the number F: float or Float. Included once for each instruction set,
// inside the loop of foreach_target.h, or alone.
#include "rtcore/math/float3-inl.h"
#include "rtcore/post/quantise.h"
#include "rtcore/simd/functions-inl.h"

#if defined(RTCORE_POST_TONE_MAP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_POST_TONE_MAP_INL_H_
#undef RTCORE_POST_TONE_MAP_INL_H_
#else
#define RTCORE_POST_TONE_MAP_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// The sigmoid Y / (Y + c) (thesis 3.2; Reinhard 2007): [0, infinity] -> [0, 1]; NaN and negative count as 0.
/// c >= 1e-30.
template <typename F>
HWY_INLINE F sigmoid(F y, std::type_identity_t<F> c) {
    return selectOrZero(y > 0.0F, 1.0F / (1.0F + c / y));
}

template <typename F>
HWY_INLINE Vec3Of<F> toneMapChannels(Vec3Of<F> x, F c) {
    return {sigmoid<F>(x.x, c), sigmoid<F>(x.y, c), sigmoid<F>(x.z, c)};
}

/// Maps the luminance and keeps the ratios of the channels. Where a channel would exceed 1, the colour is
/// blended towards the grey of the same luminance just as far as needed, so that bright colours fade to
/// white.
template <typename F>
HWY_INLINE Vec3Of<F> toneMapLuminance(Vec3Of<F> x, F c) {
    const F y = luminance<F>(x);
    const auto ordinary = isFinite(x.x) & isFinite(x.y) & isFinite(x.z) & (y < 1e30F);
    Vec3Of<F> mapped = x / (y + c);
    const F largest = maxComponent(mapped);
    // Nearly all of an image: the sigmoid itself is not needed. Its result is above 0 here.
    if (all(ordinary & (y > c * 0x1p-100F) & (largest <= 1.0F))) return mapped;
    const F l = sigmoid<F>(y, c);
    const Vec3Of<F> grey{l, l, l};
    const auto shown = l > 0.0F;
    const auto tooBright = largest > 1.0F;
    if (any(shown & tooBright)) {
        const F blend = (1.0F - l) / (largest - l);
        mapped = select(tooBright, grey * (1.0F - blend) + mapped * blend, mapped);
    }
    return selectOrZero(shown, select(ordinary, mapped, grey));
}

/// Within [0, `max`]; NaN counts as 0.
template <typename F>
HWY_INLINE Vec3Of<F> boundedChannels(Vec3Of<F> x, float max) {
    const auto bounded = [max](F channel)
                             HWY_ATTR { return selectOrZero(channel > 0.0F, min(channel, F(max))); };
    return {bounded(x.x), bounded(x.y), bounded(x.z)};
}

/// Linear light -> linear light in [0, 1]: colours are kept up to 0.76, brighter ones are compressed and fade
/// to white. (Khronos PBR Neutral Tone Mapper, 2024)
template <typename F>
HWY_INLINE Vec3Of<F> toneMapNeutral(Vec3Of<F> light) {
    constexpr float kStart = 0.8F - 0.04F, kRoom = 1 - kStart, kDesaturation = 0.15F;
    const Vec3Of<F> x = boundedChannels<F>(light, 1e15F);
    const F smallest = min(min(x.x, x.y), x.z);
    const F offset = select(smallest < 0.08F, smallest - 6.25F * smallest * smallest, F(0.04F));
    const Vec3Of<F> base{x.x - offset, x.y - offset, x.z - offset};
    const F peak = maxComponent(base);
    const auto bright = peak >= kStart;
    if (none(bright)) return base;
    const F compressed = 1.0F - kRoom * kRoom / (peak + kRoom - kStart);
    const F kept = 1.0F / (kDesaturation * (peak - compressed) + 1.0F);
    const F white = compressed * (1.0F - kept);
    const F scale = compressed / peak * kept;
    return select(bright, base * scale + Vec3Of<F>{white, white, white}, base);
}

/// The logarithm of light, and the curve of its density: an approximation by a polynomial.
HWY_INLINE Float agxCurve(Float light) {
    constexpr float kMin = -12.47393F, kMax = 4.026069F, kLog2E = 1.44269504F;
    static constexpr float kSeries[] = {-0.00232F, 0.1191F, 0.4298F, -6.868F, 31.96F, -40.14F, 15.5F};
    const Float exposed = fastLog(max(light, 1e-10F)) * kLog2E;
    return polynomial(kSeries, (clamp(exposed, kMin, kMax) - kMin) * (1 / (kMax - kMin)));
}
/// x^y of 0 <= x <= 1.
HWY_INLINE Float unitPower(Float x, float y) {
    const Float bounded = clamp(x, 1e-10F, 1.0F);
    return selectOrZero(x > 0.0F, fastExp(y * fastLog(bounded)));
}
/// The look "punchy" as far as `contrast` says: more contrast and more colour.
HWY_INLINE Float3 agxLook(Float3 code, float contrast) {
    if (contrast == 0) return code;
    const float power = 1 + 0.35F * contrast;
    const Float y = luminance<Float>(code);
    const Float3 grey{y, y, y};
    const Float3 curved{unitPower(code.x, power), unitPower(code.y, power), unitPower(code.z, power)};
    return grey + (curved - grey) * Float(1 + 0.4F * contrast);
}

/// Linear light -> linear light in [0, 1]: bright colours become pale as those of film do, and keep their
/// hue. (AgX: Sobotka 2022; matrices, curve and look as published by Wrensch, "Minimal AgX Implementation",
/// 2023)
HWY_INLINE Float3 toneMapAgx(Float3 light, float contrast) {
    constexpr float kDisplay = 2.2F; // the curve of the display that the codes are for
    const Float3 x = boundedChannels<Float>(light, 1e15F);
    const Float3 code{
        agxCurve(x.x * 0.842479062253094F + x.y * 0.0784335999999992F + x.z * 0.0792237451477643F),
        agxCurve(x.x * 0.0423282422610123F + x.y * 0.878468636469772F + x.z * 0.0791661274605434F),
        agxCurve(x.x * 0.0423756549057051F + x.y * 0.0784336F + x.z * 0.879142973793104F)};
    const Float3 c = agxLook(code, contrast);
    const Float r = c.x * 1.19687900512017F - c.y * 0.0980208811401368F - c.z * 0.0990297440797205F;
    const Float g = c.y * 1.15190312990417F - c.x * 0.0528968517574562F - c.z * 0.0989611768448433F;
    const Float b = c.z * 1.15107367264116F - c.x * 0.0529716355144438F - c.y * 0.0980434501171241F;
    return {unitPower(r, kDisplay), unitPower(g, kDisplay), unitPower(b, kDisplay)};
}

/// x where the sRGB curve is taken from its table.
template <typename F>
HWY_INLINE auto isOnChord(F x) {
    return (x > 0x1p-13F) & (x < 1.0F);
}
/// Which chord of SrgbCurve; any, where it is taken from none.
template <typename F>
HWY_INLINE auto chordOf(F x) {
    return shiftRight<SrgbCurve::kShift>(bitsOf(select(isOnChord(x), x, F(0.5F)))) - SrgbCurve::kFirst;
}
/// x on a chord -> its code before rounding, in (0, 255]; `code` and `rise` are those of the chord.
template <typename F>
HWY_INLINE F codeOnChord(F x, F code, F rise) {
    constexpr std::uint32_t kMask = (std::uint32_t{1} << SrgbCurve::kShift) - 1;
    const F rest = toFloat(toInt(bitsOf(x) & kMask));
    const F along = rest * (1.0F / static_cast<float>(kMask + 1)); // a power of two: exact
    return code + rise * along;
}
/// The same for x in [0, 1] -> [0, 255].
template <typename F>
HWY_INLINE F srgbCode(F x, F code, F rise) {
    const F linear = selectOrZero(x > 0.0F, 255 * 12.92F * x);
    return select(isOnChord(x), codeOnChord(x, code, rise), select(x >= 1.0F, F(255), linear));
}

/// A threshold in [0, 1) for each pixel, the same in every frame: neighbouring thresholds differ much, so
/// that the error of rounding spreads as fine noise (Jimenez 2014, interleaved gradient noise).
template <typename F>
HWY_INLINE F ditherThreshold(F column, float row) {
    const F inner = 0.06711056F * column + 0.00583715F * row;
    const F outer = 52.9829189F * (inner - floor(inner));
    const F threshold = outer - floor(outer);
    return selectOrZero(threshold < 1.0F, threshold);
}

/// floor(code + threshold), within 0..255.
template <typename F>
HWY_INLINE auto quantise(F code, std::type_identity_t<F> threshold) {
    const F value = code + threshold;
    return truncate(select(value >= 255.0F, F(255), selectOrZero(value > 0.0F, value)));
}
/// The same of a code that is not below 0.
template <typename F>
HWY_INLINE auto quantisePositive(F code, std::type_identity_t<F> threshold) {
    return truncate(min(code + threshold, F(255)));
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
