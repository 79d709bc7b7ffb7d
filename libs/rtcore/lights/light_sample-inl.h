// How much a light sends to a point, over the number F: float or Float. Included once for each
// instruction set, inside the loop of foreach_target.h, or alone.
#include "rtcore/lights/photometry-inl.h"
#include "rtcore/math/constants.h"
#include "rtcore/math/float3-inl.h"
#include "rtcore/sampling/disc-inl.h"
#include "rtcore/scene/light.h"
#include "rtcore/simd/functions-inl.h"

#include <limits>

#if defined(RTCORE_LIGHTS_LIGHT_SAMPLE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_LIGHTS_LIGHT_SAMPLE_INL_H_
#undef RTCORE_LIGHTS_LIGHT_SAMPLE_INL_H_
#else
#define RTCORE_LIGHTS_LIGHT_SAMPLE_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// From a point to a light that has a position.
template <typename F>
struct PathToLight {
    Vec3Of<F> direction; ///< unit; up where the distance is 0
    F distance;
    F free; ///< length of the shadow ray: a little less than the distance, so that rounding does not let a
            ///< light be occluded by the surface that it lies in
};
template <typename F>
HWY_INLINE PathToLight<F> pathToLight(const Light& light, Vec3Of<F> offset) {
    const F distance = sqrt(dot(offset, offset));
    const Vec3Of<F> direction = select(distance > 0.0F, offset / distance, broadcast<F>(Vec3{0, 1, 0}));
    return {direction, distance, max(distance * 0.9999F - ballRadius(light), F(0))};
}

template <typename F>
struct LightSample {
    Vec3Of<F> toLight;    ///< unit
    F free;               ///< length of the shadow ray
    Vec3Of<F> irradiance; ///< on a surface that faces the light, before shadows
    F spread;             ///< of a stratum of an area light: its solid angle over pi
};

/// Which stratum of an area light is sampled.
template <typename F>
struct Stratum {
    F u, v;       ///< where on the light, 0..1, without 1
    float weight; ///< of this stratum in the whole light
    float ofAll;  ///< of one of all strata that a pixel samples: highlights are widened to it
};
/// All of it, from its middle.
template <LightKind kind, typename F>
HWY_INLINE Stratum<F> wholeLight() {
    return {kind == LightKind::Sphere ? F(0) : F(0.5F), F(0.5F), 1, 0};
}

/// 1 inside the inner cone of a spot, 0 outside the outer one, smoothstep of the cosine between.
template <typename F>
HWY_INLINE F spotFactor(const Light& light, F cosine) {
    return smoothstep<F>((cosine - light.cosOuter) / (light.cosInner - light.cosOuter));
}

/// The cone that a sphere fills, seen from a point; from inside of it, all directions towards its middle's
/// side.
template <typename F>
struct SphereCone {
    Vec3Of<F> axis; ///< unit; up where the distance is 0
    F distance;     ///< of the sphere's middle
    F counted;      ///< the same, not below the radius
    F sine;         ///< of the cone's half-angle
    F whole;        ///< 1 + its cosine

    /// 1 - cosine of the half-angle, of small angles to full precision: the solid angle over 2 pi.
    HWY_INLINE F widest() const { return sine * sine / whole; }
};
/// `offset`: from the point to the sphere's middle.
template <typename F>
HWY_INLINE SphereCone<F> sphereCone(const Light& light, Vec3Of<F> offset) {
    const F radius = light.radius;
    const F distance = sqrt(dot(offset, offset));
    const Vec3Of<F> axis = select(distance > 0.0F, offset / distance, broadcast<F>(Vec3{0, 1, 0}));
    const F counted = max(max(distance, radius), F(1e-18F));
    const F sine = radius / counted;
    return {axis, distance, counted, sine, 1.0F + sqrt(max(1.0F - sine * sine, F(0)))};
}

/// A stratum of a sphere, uniform in the cone that it fills (Shirley, Wang and Zimmerman 1996).
template <typename F>
HWY_INLINE LightSample<F> sampleSphere(const Light& light, Vec3Of<F> offset, const Stratum<F>& stratum) {
    const SphereCone<F> cone = sphereCone<F>(light, offset);
    const F radius = light.radius;
    const F bent = stratum.u * cone.widest(); // 1 - cosine
    const F squareSine = bent * (2.0F - bent);
    const Vec3Of<F> toLight =
        cone.axis * (1.0F - bent) + aroundAxis<F>(cone.axis, unitCircle(stratum.v)) * sqrt(squareSine);
    const F aside = cone.distance * cone.distance * squareSine;
    const F depth = sqrt(max(radius * radius - aside, F(0)));
    const F near = cone.distance * (1.0F - bent) - depth;
    const F scale = 2 * stratum.weight / (cone.counted * cone.counted * cone.whole);
    return {toLight, max(near * 0.9999F, F(0)), broadcast<F>(light.intensity) * scale,
            cone.sine * cone.sine * stratum.ofAll};
}

/// Lower bound of the cosine between a direction and the middle of a disc: a disc that fills half of the sky
/// has no infinite weight at its rim.
inline constexpr float kMinDiscCosine = 1e-3F;

/// A stratum of a directional light. Of one with a disc it is uniform in the disc's projection on a surface
/// that faces its middle, which each sample gives the same irradiance; the middle gives what a light without
/// a size does.
template <typename F>
HWY_INLINE LightSample<F> sampleDirectional(const Light& light, const Stratum<F>& stratum) {
    const Vec3 axis = -light.direction;
    const F endless = std::numeric_limits<float>::max();
    if (!isDisc(light)) return {broadcast<F>(axis), endless, broadcast<F>(light.intensity), F(0)};
    const auto basis = basisAround(axis);
    const Disc<F> disc = onDisc<F>(stratum.u, stratum.v);
    const F x = disc.x * light.discSine, y = disc.y * light.discSine;
    const F cosine = sqrt(max(1.0F - (x * x + y * y), F(kMinDiscCosine * kMinDiscCosine)));
    const Vec3Of<F> toLight =
        broadcast<F>(axis) * cosine + broadcast<F>(basis.tangent) * x + broadcast<F>(basis.bitangent) * y;
    return {toLight, endless, broadcast<F>(light.intensity) * (stratum.weight / cosine),
            F(light.discSine * light.discSine * stratum.ofAll)};
}

/// A point on a flat light, uniform by area, as an offset from its middle.
template <LightKind kind, typename F>
HWY_INLINE Vec3Of<F> pointOnFlat(const Light& light, F u, F v) {
    static_assert(kind == LightKind::Rectangle, "where are the points of such a light?");
    return broadcast<F>(light.right * light.width) * (u - 0.5F) +
           broadcast<F>(cross(light.direction, light.right) * light.height) * (v - 0.5F);
}
template <LightKind kind>
HWY_INLINE float areaOfFlat(const Light& light) {
    static_assert(kind == LightKind::Rectangle, "how large is such a light?");
    return light.width * light.height;
}

/// The sample of `light` seen from `position`; of an area light, of the given stratum.
template <LightKind kind, typename F>
HWY_INLINE LightSample<F> sampleLight(const Light& light, Vec3Of<F> position,
                                      const Stratum<F>& stratum = wholeLight<kind, F>()) {
    constexpr LightTraits traits = traitsOf(kind);
    if constexpr (!traits.position) return sampleDirectional<F>(light, stratum);
    Vec3Of<F> offset = broadcast<F>(light.position) - position;
    if constexpr (kind == LightKind::Sphere) return sampleSphere<F>(light, offset, stratum);
    constexpr bool flat = isFlatLight(kind);
    static_assert(flat || !isAreaLight(kind) || kind == LightKind::Sphere, "how is it sampled?");
    if constexpr (flat) offset = offset + pointOnFlat<kind, F>(light, stratum.u, stratum.v);
    const PathToLight<F> path = pathToLight<F>(light, offset);
    const F counted = max(max(path.distance, F(ballRadius(light))), F(1e-18F));
    const F square = counted * counted;
    Vec3Of<F> irradiance;
    irradiance.x = light.intensity.r / square;
    // Most lights are white: this saves two divisions for them.
    irradiance.y = light.intensity.g == light.intensity.r ? irradiance.x : light.intensity.g / square;
    irradiance.z = light.intensity.b == light.intensity.r ? irradiance.x : light.intensity.b / square;
    if constexpr (traits.beam == Beam::Cone)
        irradiance = irradiance * spotFactor<F>(light, -dot(path.direction, broadcast<F>(light.direction)));
    if constexpr (traits.beam == Beam::Measured)
        irradiance = irradiance * measuredFactor<F>(light, -path.direction);
    F spread = F(0);
    if constexpr (flat) {
        const float area = areaOfFlat<kind>(light) * stratum.ofAll / kPi;
        const F front = max(-dot(path.direction, broadcast<F>(light.direction)), F(0));
        irradiance = irradiance * (front * stratum.weight);
        spread = area * front / square;
    }
    return {path.direction, path.free, irradiance, spread};
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
