// Light sampling with densities, for each kind of light: a sample of a direction, and the density of a
// direction that another strategy chose. Over the number F: float or Float. Included once for each
// instruction set, inside the loop of foreach_target.h, or alone.
#include "rtcore/lights/light_hit-inl.h"
#include "rtcore/lights/rectangle_sample-inl.h"

#if defined(RTCORE_LIGHTS_LIGHT_DIRECTION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_LIGHTS_LIGHT_DIRECTION_INL_H_
#undef RTCORE_LIGHTS_LIGHT_DIRECTION_INL_H_
#else
#define RTCORE_LIGHTS_LIGHT_DIRECTION_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// The density by solid angle with which sampleLightDirection() finds the direction of a ray that meets the
/// light at `distance`, hitLight() of it. 0 of lights that no ray meets.
template <LightKind kind, typename F>
HWY_INLINE F lightDirectionDensity(const Light& light, Vec3Of<F> origin, Vec3Of<F> direction, F distance) {
    if constexpr (kind == LightKind::Rectangle) return rectangleDensity<F>(light, origin, distance);
    return sampleDensity<kind, F>(light, origin, direction, distance);
}

/// A sample of `light` seen from `position`: of area lights at u, v (0..1, without 1), a sphere by its cone,
/// a rectangle by its solid angle, a directional light by its disc; of others all there is.
template <LightKind kind, typename F>
HWY_INLINE LightDirectionSample<F> sampleLightDirection(const Light& light, Vec3Of<F> position, F u, F v) {
    if constexpr (kind == LightKind::Rectangle) {
        return sampleRectangleBySolidAngle<F>(light, position, u, v);
    } else {
        static_assert(!isFlatLight(kind), "its density needs the distance");
        const LightSample<F> sample = sampleLight<kind, F>(light, position, Stratum<F>{u, v, 1, 0});
        return {sample.toLight, sample.free, sample.irradiance,
                sampleDensity<kind, F>(light, position, sample.toLight, F(0))};
    }
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
