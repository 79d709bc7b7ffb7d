// A clear coat of varnish over the lobes of a surface, over the number F: float or Float. Included once for
// each instruction set, inside the loop of foreach_target.h, or alone.
#include "rtcore/scattering/fresnel-inl.h"
#include "rtcore/scattering/ggx-inl.h"
#include "rtcore/scattering/ggx_albedo-inl.h"
#include "rtcore/scattering/metallic-inl.h"

#if defined(RTCORE_SCATTERING_COAT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_SCATTERING_COAT_INL_H_
#undef RTCORE_SCATTERING_COAT_INL_H_
#else
#define RTCORE_SCATTERING_COAT_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// Reflectance of varnish at normal incidence: an index of 1.5.
inline constexpr float kCoatReflectance = 0.04F;

/// A lobe of GGX of no colour, which reflects once. (glTF 2, KHR_materials_clearcoat)
template <typename F>
struct CoatLobe {
    F weight; ///< how much of the surface it covers, 0..1: a factor on the lobe
    F albedo; ///< for even light; the lobes below get the rest, so that white surfaces give off all they get
    F alpha;
};

/// `weight`, `roughness`: 0..1; `cosine`: of the viewer with the normal, lifted.
template <typename F>
HWY_INLINE CoatLobe<F> coatLobe(const GgxAlbedoTable& table, F weight, F roughness, F cosine) {
    const GgxAlbedo<F> albedo = ggxAlbedo<F>(table, cosine, roughness);
    return {weight, weight * (kCoatReflectance * albedo.straight + albedo.grazing), ggxAlpha<F>(roughness)};
}

/// The lobes below get so much of the light.
template <typename F>
HWY_INLINE void layUnder(F left, MetallicLobes<F>& lobes) {
    lobes.diffuse *= left;
    lobes.straight *= left;
    lobes.grazing *= left;
    lobes.glossAlbedo *= left;
    lobes.further *= left;
}

/// Of light that is mirrored at facets with this cosine.
template <typename F>
HWY_INLINE F coatFresnel(F cosine) {
    return fresnelSchlick<F>(broadcast<F>(kWhite * kCoatReflectance), cosine).x;
}

/// `toViewer` as liftedViewer() gives it. All 0 where the light is below the surface. The density is that of
/// sampleGgx().
template <typename F>
HWY_INLINE Scattering<F> scatterCoat(const CoatLobe<F>& coat, Vec3Of<F> normal, Vec3Of<F> toViewer,
                                     Vec3Of<F> toLight) {
    const GgxScattering<F> facets = scatterGgx<F>(normal, toViewer, toLight, coat.alpha);
    return {broadcast<F>(kWhite) * (coat.weight * coatFresnel<F>(facets.fresnelCosine) * facets.lobe),
            facets.density};
}

/// The probability that a direction is sampled by the coat: its part of all that is scattered, of which the
/// lobes below scatter `below`.
template <typename F>
HWY_INLINE F coatProbability(F coatAlbedo, Vec3Of<F> below) {
    const F all = coatAlbedo + luminance<F>(below);
    return selectOrZero(all > 0.0F, coatAlbedo / all);
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
