// Which texels a coordinate lies between, over the number F: float or Float. Included once for each
// instruction set, inside the loop of foreach_target.h, or alone.
#include "rtcore/scene/model.h"
#include "rtcore/simd/wide-inl.h"

#if defined(RTCORE_SHADING_SURFACE_TEXTURE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_SHADING_SURFACE_TEXTURE_INL_H_
#undef RTCORE_SHADING_SURFACE_TEXTURE_INL_H_
#else
#define RTCORE_SHADING_SURFACE_TEXTURE_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// Two neighbours, and the weight of the second.
template <typename F>
struct Taps {
    UintOf<F> first, second;
    F fraction;
};

/// `coordinate` counts whole images, `size` is in texels, `wrap` a TextureWrap; `repeats`: it is Repeat.
/// A coordinate that is not a number counts as the first texel.
template <bool repeats, typename F>
HWY_INLINE Taps<F> tapsAt(F coordinate, UintOf<F> size, UintOf<F> wrap) {
    const auto n = toInt(size);
    const auto fractionOf = [](F x) HWY_ATTR { return x - floor(x); };
    F inside = fractionOf(coordinate);
    auto atEdge = inside != inside; // of those that do not repeat
    if constexpr (!repeats) {
        const auto clamps = wrap == static_cast<std::uint32_t>(TextureWrap::ClampToEdge);
        const auto mirrors = wrap == static_cast<std::uint32_t>(TextureWrap::MirroredRepeat);
        const F pair = 2.0F * fractionOf(coordinate * 0.5F);
        inside = select(clamps, clamp(coordinate, 0.0F, 1.0F), inside);
        inside = select(mirrors, 1.0F - abs(1.0F - pair), inside);
        atEdge = clamps | mirrors;
    }
    const auto finite = (inside >= 0.0F) & (inside <= 1.0F);
    const F x = selectOrZero(finite, inside) * toFloat(n) - 0.5F;
    const F whole = floor(x);
    // From -1 to size, since numbers round: brought back by comparisons, which cost less than a remainder.
    const auto base = truncate(whole);
    const auto texel = [&](IntOf<F> i) HWY_ATTR {
        const IntOf<F> below = select(atEdge, IntOf<F>(0), i + n), above = select(atEdge, n - 1, i - n);
        return toUint(selectOrZero(finite, select(i < n, select(i < 0, below, i), above)));
    };
    return {texel(base), texel(base + 1), selectOrZero(finite, x - whole)};
}

/// Both the nearer of the two where `nearest` is set.
template <typename F, typename M>
HWY_INLINE Taps<F> sharpened(Taps<F> taps, M nearest) {
    const UintOf<F> nearer = select(taps.fraction < 0.5F, taps.first, taps.second);
    return {select(nearest, nearer, taps.first), select(nearest, nearer, taps.second),
            select(nearest, F(0.0F), taps.fraction)};
}

/// Texels in blocks are numbered block by block, 16 each: a texel's number is that of its column plus that of
/// its row. U: std::uint32_t or Uint.
template <typename U>
HWY_INLINE U columnInBlocks(U x) {
    return shiftLeft<2>(x) - U(3U) * (x & U(3U));
}
template <typename U>
HWY_INLINE U rowInBlocks(U y, U width) {
    const U whole = shiftLeft<2>(shiftRight<2>(width + U(3U)));
    return shiftLeft<2>(shiftRight<2>(y) * whole + (y & U(3U)));
}

/// Exact where both are equal, so that what is solid all over has no hole.
template <typename V, typename F>
HWY_INLINE V mix(V a, V b, F fraction) {
    return a + (b - a) * fraction;
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
