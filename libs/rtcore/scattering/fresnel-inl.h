// How mirrors divide light, over the number F: float or Float. Included once for each instruction set, inside
// the loop of foreach_target.h, or alone.
#include "rtcore/math/float3-inl.h"

#if defined(RTCORE_SCATTERING_FRESNEL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_SCATTERING_FRESNEL_INL_H_
#undef RTCORE_SCATTERING_FRESNEL_INL_H_
#else
#define RTCORE_SCATTERING_FRESNEL_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// Schlick 1994: the reflectance of a mirror, from `normal` straight on to white at grazing angles.
template <typename F>
HWY_INLINE Vec3Of<F> fresnelSchlick(Vec3Of<F> normal, F cosine) {
    const F x = 1.0F - clamp(cosine, 0.0F, 1.0F);
    return normal + (broadcast<F>(kWhite) - normal) * (x * x * x * x * x);
}

/// The direction in which a mirror is seen: that of the viewer, mirrored at the shading normal, and bent back
/// where that leads into the surface. All of unit length; the result is not yet.
template <typename F>
HWY_INLINE Vec3Of<F> mirrorDirection(Vec3Of<F> toViewer, Vec3Of<F> shadingNormal, Vec3Of<F> geometricNormal) {
    constexpr float kLowest = 1e-3F;
    const Vec3Of<F> mirrored = shadingNormal * (2.0F * dot(toViewer, shadingNormal)) - toViewer;
    const F height = dot(mirrored, geometricNormal);
    return select(height < kLowest, mirrored + geometricNormal * (kLowest - height), mirrored);
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
