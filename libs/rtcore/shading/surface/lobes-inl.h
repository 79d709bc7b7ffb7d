// How surfaces scatter light: the one place where the lobes of a material are put together, for all
// integrators. Included once for each instruction set, inside the loop of foreach_target.h.
#include "rtcore/math/constants.h"
#include "rtcore/scattering/coat-inl.h"
#include "rtcore/scattering/metallic-inl.h"
#include "rtcore/scattering/phong_scattering-inl.h"
#include "rtcore/shading/surface/material_rows-inl.h"
#include "rtcore/shading/surface/surface_wave.h"

#if defined(RTCORE_SHADING_SURFACE_LOBES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_SHADING_SURFACE_LOBES_INL_H_
#undef RTCORE_SHADING_SURFACE_LOBES_INL_H_
#else
#define RTCORE_SHADING_SURFACE_LOBES_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// As in SurfaceWave.
struct PointNormals {
    Float3 geometric, shading;
};
HWY_INLINE PointNormals normalsAt(const SurfaceWave& s, std::size_t i) {
    return {loadAt(s.geometricNormal, i), loadAt(s.shadingNormal, i)};
}

/// Cosines of the light with the normals.
struct Incidence {
    Float geometric, shading;
    Mask above; ///< the surface; no other light is scattered
};
HWY_INLINE Incidence incidenceOf(const PointNormals& normals, Float3 toLight) {
    const Float geometric = dot(normals.geometric, toLight), shading = dot(normals.shading, toLight);
    return {geometric, shading, (geometric > 0.0F) & (shading > 0.0F)};
}

/// Consecutive points, and which lobes they have. What the lobes need is looked up where they are asked:
/// most points have none beside the diffuse one.
struct PointLobes {
    const MaterialRow* rows;
    const SurfaceWave& s;
    std::size_t i; ///< of the first point
    const PointNormals& normals;
    Mask used;     ///< one at least
    Mask glossy;   ///< these have Phong's lobes beside the diffuse one
    Mask metallic; ///< these have the lobes of metallic-inl.h in place of all of those
    Mask coated;   ///< some of these have a coat over them
    bool anyGlossy, anyMetallic, anyCoated;
};
HWY_INLINE PointLobes lobesOf(const MaterialRow* rows, const SurfaceWave& s, std::size_t i, Mask used,
                              const PointNormals& normals) {
    const Uint traits = load(s.traits + i);
    const Mask glossy = used & hasTrait(traits, traits::kGlossy | traits::kRough);
    const Mask metallic = used & hasTrait(traits, traits::kMetallic);
    const Mask coated = used & hasTrait(traits, traits::kCoated);
    return {rows, s, i, normals, used, glossy, metallic, coated, any(glossy), any(metallic), any(coated)};
}

/// Lobes of points that are not metallic; undefined for others.
HWY_INLINE PhongLobes<Float> phongOf(const PointLobes& points) {
    const Float3 diffuse = loadAt(points.s.diffuseBrdf, points.i);
    if (!points.anyGlossy) return {diffuse, Float3{}, Float(kMinShininess), Float(0), Float(0)};
    const Rows row(points.rows, points.s.material + points.i, points.glossy);
    Float3 specular = selectOrZero(points.glossy, row.get(&MaterialRow::specular));
    if (points.s.tint.x != nullptr) specular = specular * loadAt(points.s.tint, points.i);
    return {diffuse, specular, select(points.glossy, row.get(&MaterialRow::shininess), Float(kMinShininess)),
            selectOrZero(points.glossy, row.get(&MaterialRow::lobeScale)),
            selectOrZero(points.glossy, row.get(&MaterialRow::roughScale))};
}

/// Lobes of metallic points; undefined for others.
HWY_INLINE MetallicLobes<Float> metalOf(const PointLobes& points) {
    const SurfaceWave& s = points.s;
    const std::size_t i = points.i;
    const Float3 further = loadAt(s.further, i);
    return {loadAt(s.diffuseBrdf, i) * kPi,
            loadAt(s.straight, i),
            loadAt(s.grazing, i),
            loadAt(s.gloss, i) - further,
            further,
            loadAt(s.furtherShape, i),
            load(s.alpha + i)};
}

/// Of coated points; undefined for others.
HWY_INLINE CoatLobe<Float> coatOf(const PointLobes& points) {
    const SurfaceWave& s = points.s;
    return {load(s.coat + points.i), load(s.coatAlbedo + points.i), load(s.coatAlpha + points.i)};
}

/// The probability that directions of metallic points are sampled by their coat.
HWY_INLINE Float coatProbability(const PointLobes& points, const CoatLobe<Float>& coat) {
    const Float3 below = loadAt(points.s.diffuseBrdf, points.i) * kPi + loadAt(points.s.gloss, points.i);
    return selectOrZero(points.coated, coatProbability<Float>(coat.albedo, below));
}

/// The fraction of light that all lobes scatter.
HWY_INLINE Float3 albedoOf(const PointLobes& points) {
    const Float3 diffuse = loadAt(points.s.diffuseBrdf, points.i) * kPi;
    Float3 albedo = diffuse;
    if (points.anyGlossy) albedo = albedo + phongOf(points).specular;
    if (points.anyMetallic)
        albedo = select(points.metallic, diffuse + loadAt(points.s.gloss, points.i), albedo);
    if (points.anyCoated)
        albedo = select(points.coated, albedo + broadcast(kWhite) * coatOf(points).albedo, albedo);
    return albedo;
}

/// Changes of highlights by a light.
struct Highlights {
    Float spread;    ///< solid angle over pi of the light's stratum that is looked at: they are no narrower,
                     ///< else they are undersampled
    Float metalLeft; ///< fraction of metal's that counts; mirrored rays show the rest
    Float coatLeft;  ///< the same of coats
};

/// In which order the lobes of metal are summed up. Each integrator keeps its own, and so the bits of its
/// images.
enum class SumOrder { OfRays, OfPaths };

struct Scattered {
    Float3 value;  ///< f cos theta, with the terminator's factor
    Float density; ///< 1/sr; of sampleLobes()
};

/// Light from `toLight`, of unit length; undefined where it is not above the surface. `widens`: highlights
/// are no narrower than highlights.spread. What is not used of the result costs nothing.
template <bool widens, SumOrder order>
HWY_INLINE Scattered scatteredFrom(const PointLobes& points, Float3 toLight, const Incidence& incidence,
                                   const Highlights& highlights) {
    const Float3 normal = points.normals.shading;
    const Float3 diffuse = loadAt(points.s.diffuseBrdf, points.i);
    Scattering<Float> all{diffuse, lambertDensity<Float>(incidence.shading)};
    if (points.anyGlossy) {
        PhongLobes<Float> lobes = phongOf(points);
        if constexpr (widens) widenLobe(highlights.spread, lobes.shininess, lobes.lobeScale);
        all = scatterPhong<Float>(lobes, normal, loadAt(points.s.toViewer, points.i), toLight);
    }
    if (points.anyMetallic) {
        MetallicLobes<Float> lobes = metalOf(points);
        if constexpr (widens) lobes.alpha = widenedAlpha<Float>(lobes.alpha, highlights.spread);
        const Float3 viewer = liftedViewer<Float>(loadAt(points.s.toViewer, points.i), normal);
        const MetallicTerms<Float> terms =
            metallicTerms<Float>(lobes, normal, viewer, toLight, highlights.metalLeft);
        const Float3 metal = order == SumOrder::OfPaths ? metallicReflectance<Float>(lobes, terms)
                                                        : metallicReflectance<Float>(lobes, terms, diffuse);
        all = {select(points.metallic, metal, all.reflectance),
               select(points.metallic, metallicDensity<Float>(lobes, terms, incidence.shading), all.density)};
    }
    if (points.anyCoated) {
        CoatLobe<Float> coat = coatOf(points);
        const Float probability = coatProbability(points, coat);
        if constexpr (widens) coat.alpha = widenedAlpha<Float>(coat.alpha, highlights.spread);
        const Float3 viewer = liftedViewer<Float>(loadAt(points.s.toViewer, points.i), normal);
        const Scattering<Float> varnish = scatterCoat<Float>(coat, normal, viewer, toLight);
        const Float3 both = all.reflectance + varnish.reflectance * highlights.coatLeft;
        const Float density = all.density + (varnish.density - all.density) * probability;
        all = {select(points.coated, both, all.reflectance), select(points.coated, density, all.density)};
    }
    const Float factor = incidence.shading * terminatorFactor<Float>(points.normals.geometric, normal,
                                                                     incidence.geometric, incidence.shading);
    return {all.reflectance * factor, all.density};
}

struct LobeSample {
    Float3 direction; ///< unit; may be below the surface, where nothing is scattered
    Mask matte;       ///< it was sampled for a lobe without a highlight
};

/// A direction with the density of scatteredFrom(), by the random numbers `lobe` and `point`, each 0..1,
/// without 1.
HWY_INLINE LobeSample sampleLobes(const PointLobes& points, Float lobe, SquarePointOf<Float> point) {
    const Float3 normal = points.normals.shading, toViewer = loadAt(points.s.toViewer, points.i);
    LobeSample sample{Float3{}, points.used};
    Mask varnished = without(points.coated, points.coated);
    CoatLobe<Float> coat{};
    if (points.anyCoated) {
        coat = coatOf(points);
        const Float probability = coatProbability(points, coat);
        varnished = points.coated & (lobe < probability);
        const Float rest = (lobe - probability) / max(1.0F - probability, 1e-6F);
        lobe = select(without(points.coated, varnished), min(rest, 0.99999994F), lobe);
    }
    if (any(without(points.used, points.metallic))) {
        const PhongLobes<Float> lobes = phongOf(points);
        sample.direction = samplePhongScattering<Float>(lobes, normal, toViewer, lobe, point);
        sample.matte = !(lobe < phongProbability<Float>(lobes, dot(normal, toViewer)));
    }
    if (points.anyMetallic) {
        const MetallicLobes<Float> lobes = metalOf(points);
        const Float3 viewer = liftedViewer<Float>(toViewer, normal);
        const Float3 direction = sampleMetallic<Float>(lobes, normal, viewer, lobe, point);
        sample.direction = select(points.metallic, direction, sample.direction);
        // Multiple scattering of metal is sampled as matte surfaces are, but is not matte.
        const Mask matte = without(!(lobe < glossProbability<Float>(lobes)), isZero(lobes.diffuse));
        sample.matte = (points.metallic & matte) | without(sample.matte, points.metallic);
        if (any(varnished)) {
            const Float3 mirrored = sampleGgx<Float>(normal, viewer, coat.alpha, point);
            sample.direction = select(varnished, mirrored, sample.direction);
            sample.matte = without(sample.matte, varnished);
        }
    }
    return sample;
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
