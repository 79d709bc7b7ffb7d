// From radiance to codes of sRGB, over the number F: float or Float. Included once for each instruction set,
// inside the loop of foreach_target.h, or alone.
#include "rtcore/math/float3-inl.h"
#include "rtcore/post/quantise.h"

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
