// Fog along rays, over the number F: float for single rays, Float for waves of them (shading/fog/fog.h says
// what the functions mean). Single rays take the exponential function of portable_math.h, waves the
// fast one (fogExp), and images show both. Included once for each instruction set,
// inside the loop of foreach_target.h, or alone.
#include "rtcore/math/float3-inl.h"
#include "rtcore/shading/fog/fog.h"
#include "rtcore/simd/functions-inl.h"

#if defined(RTCORE_SHADING_FOG_FOG_MATH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_SHADING_FOG_FOG_MATH_INL_H_
#undef RTCORE_SHADING_FOG_FOG_MATH_INL_H_
#else
#define RTCORE_SHADING_FOG_FOG_MATH_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// The exponential function of fog.
HWY_INLINE float fogExp(float x) { return portableExp(x); }
HWY_INLINE Float fogExp(Float x) { return fastExp(x); }

/// (1 - e^-x) / x by its series, for 0 <= x <= 0.25.
template <typename F>
HWY_INLINE F meanDecaySeries(F x) {
    static constexpr float kSeries[] = {1, -1.0F / 2, 1.0F / 6, -1.0F / 24, 1.0F / 120, -1.0F / 720};
    return polynomial(kSeries, x);
}

/// (1 - e^-x) / x for x >= 0, also of infinity.
template <typename F>
HWY_INLINE F meanDecay(F x) {
    return select(x < 0.25F, meanDecaySeries(min(x, F(0.25F))), (1.0F - fogExp(-x)) / x);
}

/// Height above the ground in scale heights.
template <typename F>
HWY_INLINE F fogHeight(const FogMedium& fog, Vec3Of<F> position) {
    return max((dot(broadcast<F>(fog.up), position) - fog.ground) * fog.perHeight, F(FogMedium::kLowest));
}
/// How much of it a ray gains on its way of 1.
template <typename F>
HWY_INLINE F fogSlope(const FogMedium& fog, Vec3Of<F> direction) {
    return dot(broadcast<F>(fog.up), direction) * fog.perHeight;
}

/// fogLength() in exponential fog; `from` is the height of the origin.
template <typename F>
HWY_INLINE F exponentialLength(F from, F slope, F distance) {
    const F steepness = abs(slope);
    const F to = max(from + slope * distance, F(FogMedium::kLowest));
    const F rise = steepness * distance;
    const F densest = fogExp(-min(from, to));
    // With endless rays distance * meanDecay() would be infinity * 0.
    return select(rise > 16.0F, densest / steepness, densest * distance * meanDecay(rise));
}

template <typename F>
HWY_INLINE F fogLength(bool exponential, const FogMedium& fog, Vec3Of<F> origin, Vec3Of<F> direction,
                       F distance) {
    if (!exponential) return distance;
    return exponentialLength<F>(fogHeight<F>(fog, origin), fogSlope<F>(fog, direction), distance);
}

/// 1 - e^-tau for tau >= 0.
template <typename F>
HWY_INLINE F fogOpacity(F tau) {
    return select(tau < 16.0F, tau * meanDecay(tau), F(1));
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
