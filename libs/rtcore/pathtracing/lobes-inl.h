// How points scatter light in path tracing: what all their lobes send from one direction into another, with
// what density they draw it, and one that is drawn. Included once for each instruction set, inside the loop
// of foreach_target.h.
#include "rtcore/math/constants.h"
#include "rtcore/scattering/fresnel-inl.h"
#include "rtcore/scattering/metallic-inl.h"
#include "rtcore/scattering/phong_scattering-inl.h"
#include "rtcore/shading/surface/material_rows-inl.h"
#include "rtcore/shading/surface/surface_wave.h"

#if defined(RTCORE_PATHTRACING_LOBES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_PATHTRACING_LOBES_INL_H_
#undef RTCORE_PATHTRACING_LOBES_INL_H_
#else
#define RTCORE_PATHTRACING_LOBES_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// Of consecutive points.
struct PointLobes {
    Float3 geometricNormal, normal, toViewer; ///< as in SurfaceWave
    PhongLobes<Float> phong;
    Mask metallic; ///< these have the lobes below in place of those above
    bool anyPhong; ///< some have those above
    MetallicLobes<Float> metal;
    Float3 metalViewer; ///< lifted
    Float mirror;       ///< with what probability the path goes on as the mirror does, 0..1
    Mask drawable;      ///< there is something to draw from
};

/// Of the `used` points.
HWY_INLINE PointLobes lobesOf(const MaterialRow* rows, const SurfaceWave& s, std::size_t i, Mask used) {
    const Uint traits = load(s.traits + i);
    PointLobes lobes{};
    lobes.metallic = used & hasTrait(traits, traits::kMetallic);
    lobes.anyPhong = any(without(used, lobes.metallic));
    lobes.geometricNormal = loadAt(s.geometricNormal, i);
    lobes.normal = loadAt(s.shadingNormal, i);
    lobes.toViewer = loadAt(s.toViewer, i);
    lobes.phong.diffuse = loadAt(s.diffuse, i);
    lobes.phong.shininess = Float(kLeastShininess);
    const Mask glossy = used & hasTrait(traits, traits::kGlossy | traits::kRough);
    if (any(glossy)) {
        const Rows ofPoints(rows, s.material + i, glossy);
        lobes.phong.specular = selectOrZero(glossy, ofPoints.get(&MaterialRow::specular));
        if (s.tint.x != nullptr) lobes.phong.specular = lobes.phong.specular * loadAt(s.tint, i);
        lobes.phong.shininess = select(glossy, ofPoints.get(&MaterialRow::shininess), lobes.phong.shininess);
        lobes.phong.lobeScale = selectOrZero(glossy, ofPoints.get(&MaterialRow::lobeScale));
        lobes.phong.roughScale = selectOrZero(glossy, ofPoints.get(&MaterialRow::roughScale));
    }
    const Mask mirrors = used & hasTrait(traits, traits::kSpecular);
    Float mirrored{};
    if (any(mirrors)) {
        mirrored = selectOrZero(mirrors, max(luminance<Float>(loadAt(s.specular, i)), 0.0F));
    }
    Float3 albedo = lobes.phong.diffuse * kPi + lobes.phong.specular;
    if (any(lobes.metallic)) {
        const Float3 gloss = loadAt(s.gloss, i), further = loadAt(s.further, i);
        lobes.metal = {
            lobes.phong.diffuse * kPi, loadAt(s.straight, i), loadAt(s.grazing, i), gloss - further, further,
            loadAt(s.furtherShape, i), load(s.alpha + i)};
        lobes.metalViewer = liftedViewer<Float>(lobes.toViewer, lobes.normal);
        albedo = select(lobes.metallic, lobes.metal.diffuse + gloss, albedo);
    }
    const Float scattered = max(luminance<Float>(loadAt(s.weight, i) * albedo), 0.0F);
    const Float both = mirrored + scattered;
    lobes.drawable = used & ((both > 0.0F) & isFinite(both));
    if (any(mirrors)) {
        lobes.mirror = selectOrZero(lobes.drawable, mirrored / select(lobes.drawable, both, Float(1)));
    }
    return lobes;
}

struct Scattered {
    Float3 value;  ///< f cos theta, with the terminator's factor
    Float density; ///< 1/sr; of drawing the direction by any lobe that is no mirror
};

/// Of light from `toLight`, of unit length; zero where it is below the surface.
HWY_INLINE Scattered scatteredFrom(const PointLobes& lobes, Float3 toLight) {
    const Float geometric = dot(lobes.geometricNormal, toLight);
    const Float cosine = dot(lobes.normal, toLight);
    const Mask lit = (geometric > 0.0F) & (cosine > 0.0F);
    Scattering<Float> all{};
    if (lobes.anyPhong) all = scatterPhong<Float>(lobes.phong, lobes.normal, lobes.toViewer, toLight);
    if (any(lobes.metallic)) {
        const Scattering<Float> metal =
            scatterMetallic<Float>(lobes.metal, lobes.normal, lobes.metalViewer, toLight);
        all = {select(lobes.metallic, metal.reflectance, all.reflectance),
               select(lobes.metallic, metal.density, all.density)};
    }
    const Float factor =
        cosine * terminatorFactor<Float>(lobes.geometricNormal, lobes.normal, geometric, cosine);
    return {selectOrZero(lit, all.reflectance * factor),
            selectOrZero(lit, (1.0F - lobes.mirror) * all.density)};
}

struct DrawnWay {
    Float3 direction; ///< unit
    Mask mirrored;    ///< it is the one direction of a mirror
    Mask matte;       ///< it is drawn for a lobe that has no highlight
};

/// A direction by `lobe` and `point`, each 0..1, without 1.
HWY_INLINE DrawnWay drawWay(const PointLobes& lobes, Float lobe, SquarePointOf<Float> point) {
    const Mask mirrored = lobes.drawable & (lobe < lobes.mirror);
    const Float rest = (lobe - lobes.mirror) / max(1.0F - lobes.mirror, 1e-6F);
    Float3 direction{};
    if (lobes.anyPhong) {
        direction = drawPhongScattering<Float>(lobes.phong, lobes.normal, lobes.toViewer, rest, point);
    }
    if (any(lobes.metallic)) {
        const Float3 drawn = drawMetallic<Float>(lobes.metal, lobes.normal, lobes.metalViewer, rest, point);
        direction = select(lobes.metallic, drawn, direction);
    }
    if (any(mirrored)) {
        const Float3 mirror = mirrorDirection<Float>(lobes.toViewer, lobes.normal, lobes.geometricNormal);
        direction = select(mirrored, normalize(mirror, mirrored), direction);
    }
    Float gloss{};
    if (lobes.anyPhong) {
        gloss = phongProbability<Float>(lobes.phong, dot(lobes.normal, lobes.toViewer));
    }
    if (any(lobes.metallic)) gloss = select(lobes.metallic, glossProbability<Float>(lobes.metal), gloss);
    // What metal scatters further is drawn as matte surfaces are, and is none.
    const Mask matte = without(!(rest < gloss), lobes.metallic & isZero(lobes.metal.diffuse));
    return {direction, mirrored, matte};
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
