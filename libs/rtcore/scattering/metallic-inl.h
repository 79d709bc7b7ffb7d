// The metallic-roughness model of glTF 2 as lobes that lose no light, over the number F: float or Float.
// Included once for each instruction set, inside the loop of foreach_target.h, or alone.
#include "rtcore/scattering/further_facets-inl.h"
#include "rtcore/scattering/ggx-inl.h"
#include "rtcore/scattering/ggx_albedo-inl.h"
#include "rtcore/scattering/lambert-inl.h"

#if defined(RTCORE_SCATTERING_METALLIC_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_SCATTERING_METALLIC_INL_H_
#undef RTCORE_SCATTERING_METALLIC_INL_H_
#else
#define RTCORE_SCATTERING_METALLIC_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// Each channel that is below 0 becomes 0.
template <typename F>
HWY_INLINE Vec3Of<F> atLeastZero(Vec3Of<F> v) {
    return {max(v.x, F(0)), max(v.y, F(0)), max(v.z, F(0))};
}

/// A point's lobes as one viewer sees them.
template <typename F>
struct MetallicLobes {
    Vec3Of<F> diffuse;           ///< albedo
    Vec3Of<F> straight, grazing; ///< factors on the GGX lobe for facets seen straight on and at right angles
    Vec3Of<F> glossAlbedo;       ///< of the GGX lobe, for even light
    Vec3Of<F> further;           ///< albedo of the wide part of what metal sends after further facets
    Vec3Of<F> shape;             ///< of that, for furtherFactor()
    F alpha;
};

/// Where the gloss is faint, the factor on a GGX lobe that puts back what is scattered from facet to facet
/// before it leaves: of even light one reflection takes `once`, and of the rest each further one the mean
/// over all angles of Schlick's curve (Kulla and Conty 2017, "Revisiting physically based shading", for the
/// albedo; as a factor, so that directions are sampled as before: Turquin 2019, "Practical multiple
/// scattering compensation"). Perfect mirrors give off all that they get.
template <typename F>
HWY_INLINE F factorOfFurtherFacets(const GgxAlbedo<F>& albedo, F reflectance) {
    const F once = reflectance * albedo.straight + albedo.grazing;
    const F rest = 1.0F - albedo.straight - albedo.grazing;
    const F further = reflectance + (1.0F - reflectance) * (1.0F / 21.0F);
    const F leaving = further * further * albedo.mean / (1.0F - further * (1.0F - albedo.mean));
    return 1.0F + rest * leaving / max(once, F(kMinAlbedo));
}
template <typename F>
HWY_INLINE Vec3Of<F> factorOfFurtherFacets(const GgxAlbedo<F>& albedo, Vec3Of<F> reflectance) {
    return {factorOfFurtherFacets<F>(albedo, reflectance.x), factorOfFurtherFacets<F>(albedo, reflectance.y),
            factorOfFurtherFacets<F>(albedo, reflectance.z)};
}

/// `base`, `metallic`, `roughness` as glTF has them, 0..1; `reflectance`: of what is no metal, straight on;
/// `cosine`: of the viewer with the normal, lifted. What is diffuse gets what the gloss leaves: white
/// surfaces give off all that they get. Results of metal and dielectric are mixed, not their reflectances,
/// since the factor is not linear in them.
template <typename F>
HWY_INLINE MetallicLobes<F> metallicLobes(const GgxAlbedoTable& table, Vec3Of<F> base, F metallic,
                                          F roughness, Vec3Of<F> reflectance, F cosine) {
    const GgxAlbedo<F> albedo = ggxAlbedo<F>(table, cosine, roughness);
    const F isDielectric = 1.0F - metallic;
    const Vec3Of<F> white = broadcast<F>(kWhite);
    MetallicLobes<F> lobes{};
    Vec3Of<F> other{};
    // The result of a lane must not depend on the other lanes.
    const auto mixed = isDielectric > 0.0F, isMetal = metallic > 0.0F;
    if (any(mixed)) {
        const Vec3Of<F> factor = factorOfFurtherFacets<F>(albedo, reflectance);
        const Vec3Of<F> gloss = (reflectance * albedo.straight + white * albedo.grazing) * factor;
        lobes.diffuse = selectOrZero(mixed, base * atLeastZero<F>(white - gloss) * isDielectric);
        other = selectOrZero(mixed, factor * isDielectric);
    }
    lobes.straight = other * reflectance;
    lobes.grazing = other;
    if (any(isMetal)) {
        const FurtherFacets<F> further = furtherFacets<F>(albedo, roughness, cosine);
        const Vec3Of<F> straight = white * (1.0F + further.straight) + base * further.straightByBase;
        const Vec3Of<F> grazing = white * (1.0F + further.grazing) + base * further.grazingByBase;
        const Vec3Of<F> wide{wideAlbedo<F>(further, base.x), wideAlbedo<F>(further, base.y),
                             wideAlbedo<F>(further, base.z)};
        lobes.straight += selectOrZero(isMetal, base * straight * metallic);
        lobes.grazing += selectOrZero(isMetal, grazing * metallic);
        lobes.further = selectOrZero(isMetal, wide * metallic);
        lobes.shape = selectOrZero(isMetal, further.shape);
    }
    lobes.glossAlbedo = lobes.straight * albedo.straight + lobes.grazing * albedo.grazing;
    lobes.alpha = ggxAlpha<F>(roughness);
    return lobes;
}

/// Schlick's curve between `straight` and `grazing`, for facets with this cosine to light and viewer.
template <typename F>
HWY_INLINE Vec3Of<F> glossFactor(Vec3Of<F> straight, Vec3Of<F> grazing, F cosine) {
    const F x = 1.0F - clamp(cosine, 0.0F, 1.0F);
    return straight + (grazing - straight) * (x * x * x * x * x);
}

/// The probability that sampleMetallic() follows the GGX lobe: its part of all that is scattered.
template <typename F>
HWY_INLINE F glossProbability(const MetallicLobes<F>& lobes) {
    const F gloss = luminance<F>(lobes.glossAlbedo);
    const F all = gloss + luminance<F>(lobes.diffuse) + luminance<F>(lobes.further);
    return selectOrZero(all > 0.0F, gloss / all);
}

/// The lobes' responses to light from one direction, before they are summed.
template <typename F>
struct MetallicTerms {
    Vec3Of<F> gloss; ///< f_r of the GGX lobe
    F glossDensity;  ///< of sampleGgx()
    F wide;          ///< furtherFactor()
};
/// `toViewer` as liftedViewer() gives it, that of the lobes; `glossLeft`: a factor on the GGX lobe.
template <typename F>
HWY_INLINE MetallicTerms<F> metallicTerms(const MetallicLobes<F>& lobes, Vec3Of<F> normal, Vec3Of<F> toViewer,
                                          Vec3Of<F> toLight, F glossLeft) {
    const GgxScattering<F> gloss = scatterGgx<F>(normal, toViewer, toLight, lobes.alpha);
    const Vec3Of<F> factor = glossFactor<F>(lobes.straight, lobes.grazing, gloss.fresnelCosine);
    return {
        factor * (gloss.lobe * glossLeft), gloss.density,
        furtherFactor<F>(lobes.shape, dot(normal, toViewer), dot(normal, toLight), dot(toViewer, toLight))};
}

/// f_r of all lobes; of light above the surface.
template <typename F>
HWY_INLINE Vec3Of<F> metallicReflectance(const MetallicLobes<F>& lobes, const MetallicTerms<F>& terms) {
    return (lobes.diffuse + lobes.further * terms.wide) * F(kLambertLobe) + terms.gloss;
}
/// The same but for rounding, with `diffuse` for lobes.diffuse / pi.
template <typename F>
HWY_INLINE Vec3Of<F> metallicReflectance(const MetallicLobes<F>& lobes, const MetallicTerms<F>& terms,
                                         Vec3Of<F> diffuse) {
    return diffuse + (terms.gloss + lobes.further * (terms.wide * kLambertLobe));
}
/// The density of sampleMetallic() by solid angle. `cosine`: of the light with the normal.
template <typename F>
HWY_INLINE F metallicDensity(const MetallicLobes<F>& lobes, const MetallicTerms<F>& terms, F cosine) {
    const F probability = glossProbability<F>(lobes);
    return (1.0F - probability) * lambertDensity<F>(cosine) + probability * terms.glossDensity;
}

/// `toViewer` as for metallicTerms().
template <typename F>
HWY_INLINE Scattering<F> scatterMetallic(const MetallicLobes<F>& lobes, Vec3Of<F> normal, Vec3Of<F> toViewer,
                                         Vec3Of<F> toLight) {
    const MetallicTerms<F> terms = metallicTerms<F>(lobes, normal, toViewer, toLight, F(1));
    const F cosine = dot(normal, toLight);
    const auto above = cosine > 0.0F;
    return {selectOrZero(above, metallicReflectance<F>(lobes, terms)),
            selectOrZero(above, metallicDensity<F>(lobes, terms, cosine))};
}

/// A direction of unit length with the density of scatterMetallic(). `lobe`: a random number in 0..1.
template <typename F>
HWY_INLINE Vec3Of<F> sampleMetallic(const MetallicLobes<F>& lobes, Vec3Of<F> normal, Vec3Of<F> toViewer,
                                    F lobe, SquarePointOf<F> point) {
    const auto glossy = lobe < glossProbability<F>(lobes);
    if (none(glossy)) return sampleLambert<F>(normal, point);
    const Vec3Of<F> reflected = sampleGgx<F>(normal, toViewer, lobes.alpha, point);
    if (all(glossy)) return reflected;
    return select(glossy, reflected, sampleLambert<F>(normal, point));
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
