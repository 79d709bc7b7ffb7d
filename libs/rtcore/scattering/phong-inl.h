// How surfaces scatter light, over the number F: float or Float. Included once for each instruction set,
// inside the loop of foreach_target.h, or alone.
#include "rtcore/math/constants.h"
#include "rtcore/math/float3-inl.h"
#include "rtcore/sampling/owen-inl.h"
#include "rtcore/scattering/phong.h"
#include "rtcore/simd/functions-inl.h"

#if defined(RTCORE_SCATTERING_PHONG_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_SCATTERING_PHONG_INL_H_
#undef RTCORE_SCATTERING_PHONG_INL_H_
#else
#define RTCORE_SCATTERING_PHONG_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// f_r of the Phong lobe where the mirrored light is within 90 degrees of the viewer, (n + 2) / 2 pi cos^n.
/// `cosine`: of the angle between them, > 0; `scale`: (n + 2) / 2 pi, times its fraction of the surface.
template <typename F>
HWY_INLINE F phongLobe(F cosine, F shininess, F scale) {
    return scale * pow(cosine, shininess);
}

/// Factor by which cos^n is the density of samplePhong() by solid angle. The cosine is that of phongLobe(), >
/// 0.
template <typename F>
HWY_INLINE F phongDensityScale(F shininess) {
    return (shininess + 1.0F) * (0.5F / kPi);
}

/// A direction about `mirrored`, both of unit length, with the density (n + 1) / 2 pi cos^n.
template <typename F>
HWY_INLINE Vec3Of<F> samplePhong(Vec3Of<F> mirrored, F shininess, SquarePointOf<F> point) {
    const F cosine = min(pow(1.0F - point.u, 1.0F / (shininess + 1.0F)), F(1));
    const F sine = sqrt(1.0F - cosine * cosine);
    return mirrored * cosine + aroundAxis<F>(mirrored, unitCircle<F>(point.v)) * sine;
}

/// A lobe no narrower than the stratum of the light that is looked at; else narrow highlights of area lights
/// are undersampled (specks). `spread`: the stratum's solid angle over pi.
template <typename F>
HWY_INLINE void widenLobe(F spread, F& shininess, F& scale) {
    const F wider = shininess / (1.0F + shininess * spread);
    scale = scale * ((wider + 2.0F) / (shininess + 2.0F));
    shininess = wider;
}

/// f_r of a metal of roughness 1: GGX with alpha = 1 and the height-correlated masking of Smith, which comes
/// to 1 / 2 pi (cos i + cos o). `scale`: 1 / 2 pi, times its fraction; the cosines are those of light (>= 0)
/// and viewer with the normal.
template <typename F>
HWY_INLINE F roughLobe(F toLight, F toViewer, F scale) {
    return scale / max(toLight + max(toViewer, F(0)), F(kMinCosines));
}

/// Smooth normals show a hard edge where the triangles turn away from the light. This factor on the
/// irradiance softens it (Chiang et al. 2019, "Taming the Shadow Terminator"). `geometric` and `shading` are
/// the cosines of the light with the two normals, both > 0; normals of unit length, towards the outside.
template <typename F>
HWY_INLINE F terminatorFactor(Vec3Of<F> geometricNormal, Vec3Of<F> shadingNormal, F geometric, F shading) {
    const F between = max(dot(geometricNormal, shadingNormal), F(1e-6F));
    const F g = min(F(1), geometric / (shading * between));
    return g * (1.0F + g * (1.0F - g));
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
