// Rays that meet area lights, over the number F: float or Float. No ray of the camera sees those that have a
// place, and rays of mirrors those alone that are to be seen there (mirrored_light.h); scattered rays of the
// path tracer do, as the other way to find the light that sampleLight() samples. Discs of directional lights
// are met by rays of every kind that leave the scene. Included once for each instruction set, inside the loop
// of foreach_target.h, or alone.
#include "rtcore/lights/light_sample-inl.h"

#if defined(RTCORE_LIGHTS_LIGHT_HIT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_LIGHTS_LIGHT_HIT_INL_H_
#undef RTCORE_LIGHTS_LIGHT_HIT_INL_H_
#else
#define RTCORE_LIGHTS_LIGHT_HIT_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// The radiance of an area light's surface, where it is seen from its shining side; of a directional light
/// that of its disc (isDisc()).
template <LightKind kind>
HWY_INLINE Colour radianceOf(const Light& light) {
    static_assert(isAreaLight(kind) || traitsOf(kind).disc, "lights without a size have no radiance");
    if constexpr (traitsOf(kind).disc) return light.intensity / (kPi * light.discSine * light.discSine);
    if constexpr (kind == LightKind::Sphere) return light.intensity / (kPi * light.radius * light.radius);
    if constexpr (isFlatLight(kind)) return light.intensity / areaOfFlat<kind>(light);
}

/// `offset`: from the ray's origin to the sphere's middle. From inside of it the ray meets the far side.
template <typename F>
HWY_INLINE F hitSphere(const Light& light, Vec3Of<F> offset, Vec3Of<F> direction) {
    const F radius = light.radius;
    const F distance = sqrt(dot(offset, offset));
    const F along = dot(offset, direction);
    const Vec3Of<F> aside = offset - direction * along;
    const F square = radius * radius - dot(aside, aside);
    // The larger root without cancellation; the roots' product is the square of the tangent's length.
    const F larger = along + sqrt(max(square, F(0)));
    const F outside = distance - radius;
    const F smaller = outside * (distance + radius) / larger;
    const auto meets = (square > 0.0F) & (larger > 0.0F);
    return select(meets, select(outside > 0.0F, smaller, larger), F(std::numeric_limits<float>::infinity()));
}

template <LightKind kind, typename F>
HWY_INLINE F hitFlat(const Light& light, Vec3Of<F> offset, Vec3Of<F> direction) {
    static_assert(kind == LightKind::Rectangle, "where does it end?");
    const Vec3Of<F> axis = broadcast<F>(light.direction);
    const F front = -dot(direction, axis), height = -dot(offset, axis);
    const F distance = height / front;
    const Vec3Of<F> fromMiddle = direction * distance - offset;
    const F right = dot(fromMiddle, broadcast<F>(light.right));
    const F up = dot(fromMiddle, broadcast<F>(cross(light.direction, light.right)));
    const auto meets = (front > 0.0F) & (height > 0.0F) & (abs(right) <= 0.5F * light.width) &
                       (abs(up) <= 0.5F * light.height);
    return select(meets, distance, F(std::numeric_limits<float>::infinity()));
}

/// Whether a ray that leaves the scene meets the disc of a directional light. `direction`: of unit length.
template <typename F>
HWY_INLINE auto meetsDisc(const Light& light, Vec3Of<F> direction) {
    const Vec3Of<F> axis = broadcast<F>(-light.direction);
    const F along = dot(direction, axis);
    const Vec3Of<F> aside = direction - axis * along;
    return (along > 0.0F) & (dot(aside, aside) <= light.discSine * light.discSine);
}

/// The distance, above 0, at which a ray meets an area light that has a place; infinity where it misses, and
/// of all other lights. A sphere is met from inside, too, a rectangle from its shining side alone.
/// `direction`: of unit length.
template <LightKind kind, typename F>
HWY_INLINE F hitLight(const Light& light, Vec3Of<F> origin, Vec3Of<F> direction) {
    const Vec3Of<F> offset = broadcast<F>(light.position) - origin;
    if constexpr (kind == LightKind::Sphere) {
        return hitSphere<F>(light, offset, direction);
    } else if constexpr (isFlatLight(kind)) {
        return hitFlat<kind, F>(light, offset, direction);
    } else {
        return F(std::numeric_limits<float>::infinity());
    }
}

/// The density by solid angle with which sampleLight(), given uniform u and v and all of the light, finds the
/// direction of a ray that meets it at `distance`, which does not count for a disc; 0 of lights that no ray
/// meets. From inside of a sphere
/// light it samples the half of all directions that its middle lies in: the density is 1 / (2 pi) there, 0 in
/// the other half, which is left to rays that meet it.
template <LightKind kind, typename F>
HWY_INLINE F sampleDensity(const Light& light, Vec3Of<F> origin, Vec3Of<F> direction, F distance) {
    if constexpr (kind == LightKind::Sphere) {
        const SphereCone<F> cone = sphereCone<F>(light, broadcast<F>(light.position) - origin);
        const auto sampled = (cone.distance > light.radius) | (dot(cone.axis, direction) > 0.0F);
        return selectOrZero(sampled, 1.0F / (2 * kPi * cone.widest()));
    } else if constexpr (isFlatLight(kind)) {
        const F front = -dot(direction, broadcast<F>(light.direction));
        return selectOrZero(front > 0.0F, distance * distance / (areaOfFlat<kind>(light) * front));
    } else if constexpr (traitsOf(kind).disc) {
        if (!isDisc(light)) return F(0);
        const F cosine = max(-dot(direction, broadcast<F>(light.direction)), F(kMinDiscCosine));
        return cosine / (kPi * light.discSine * light.discSine);
    } else {
        return F(0);
    }
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
