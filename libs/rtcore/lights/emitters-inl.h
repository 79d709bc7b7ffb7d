// Points of emissive triangles, over the number F: float or Float. Included once for each instruction set,
// inside the loop of foreach_target.h, or alone.
#include "rtcore/lights/emitters.h"
#include "rtcore/math/triangle-inl.h"
#include "rtcore/sampling/alias-inl.h"

#if defined(RTCORE_LIGHTS_EMITTERS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_LIGHTS_EMITTERS_INL_H_
#undef RTCORE_LIGHTS_EMITTERS_INL_H_
#else
#define RTCORE_LIGHTS_EMITTERS_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// A point of the emissive triangles: where a ray would hit it.
template <typename F>
struct EmitterSample {
    UintOf<F> triangle; ///< of the mesh
    F u, v;             ///< towards its second and third corner, as in Hit
    Vec3Of<F> position;
    Vec3Of<F> normal; ///< unit, of the triangle's front; it shines to both sides
    F density;        ///< by area
};

template <typename F>
HWY_INLINE Corners<F> cornersOf(const EmitterRows& rows, UintOf<F> triangle) {
    const auto corner = [&](std::uint32_t which) HWY_ATTR {
        const auto first =
            toInt(gather(rows.corners, toInt(triangle * UintOf<F>(3) + UintOf<F>(which))) << 2);
        return Vec3Of<F>{gather(rows.vertices, first), gather(rows.vertices + 1, first),
                         gather(rows.vertices + 2, first)};
    };
    return {corner(0), corner(1), corner(2)};
}

/// Twice the area: the length of the triangle's normal as normalOf() gives it.
template <typename F>
HWY_INLINE F doubleArea(Vec3Of<F> normal) {
    return sqrt(dot(normal, normal));
}

/// Of a cluster, 0 without a tree, uniform by area within a triangle; there is an emitter. `bits`: 32 random
/// ones. (Heitz 2019, "A Low-Distortion Map Between Triangle and Square")
template <typename F>
HWY_INLINE EmitterSample<F> sampleEmitter(const EmitterRows& rows, F u, F v, UintOf<F> bits,
                                          UintOf<F> cluster = UintOf<F>(0U)) {
    const UintOf<F> emitter = sampleIndex<F>(rows.choice, bits, cluster << rows.rowBits);
    const UintOf<F> triangle = gather(rows.triangles, toInt(emitter));
    const Corners<F> corners = cornersOf<F>(rows, triangle);
    const auto upper = v > u;
    const F half = 0.5F * min(u, v);
    const F second = select(upper, half, u - half), third = select(upper, v - half, half);
    const Vec3Of<F> normal = normalOf<F>(corners);
    const F twice = doubleArea<F>(normal);
    return {triangle,       second,
            third,          interpolate<F>(corners, second, third),
            normal / twice, 2.0F * probabilityOf<F>(rows.choice, emitter) / twice};
}

/// By solid angle, of a density by area at that distance, where the cosine between the direction and the
/// triangle's normal is `cosine`, of either sign. 0 where it is so small that a point tells nothing about its
/// surroundings.
template <typename F>
HWY_INLINE F bySolidAngle(F areaDensity, F distance, F cosine) {
    const F front = abs(cosine);
    return selectOrZero(front > 1e-6F, areaDensity * (distance * distance / front));
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
