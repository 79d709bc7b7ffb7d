#include "rtcore/shading/light/light_wave.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/shading/light/light_wave.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/lights/light_sample-inl.h"
#include "rtcore/lights/rectangle_sample-inl.h"
#include "rtcore/scattering/metallic-inl.h"
#include "rtcore/scattering/phong-inl.h"
#include "rtcore/shading/surface/faded_mirror-inl.h"
#include "rtcore/shading/surface/material_rows-inl.h"

#ifndef RTCORE_SHADING_LIGHT_LIGHT_WAVE_TYPES
#define RTCORE_SHADING_LIGHT_LIGHT_WAVE_TYPES
namespace rtcore {

/// Where shadow rays go: arrays with room for every point and a block more.
struct ShadowArrays {
    ArraysOf3 origin, direction;
    float* tMax;
    std::uint32_t* point;
};

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// The strata sampled for the points from `i` on.
template <LightKind kind>
HWY_INLINE Stratum<Float> strataOf(const LightStrata* strata, std::size_t i) {
    if (strata == nullptr) return wholeLight<kind, Float>();
    const auto unit = [&](const std::uint32_t* bits, std::uint32_t added) {
        return toFloat(toInt(shiftRight<8>(load(bits + i) + added))) * 0x1p-24F;
    };
    return {unit(strata->u, strata->du), unit(strata->v, strata->dv), strata->weight, strata->ofAll};
}

/// k_s of the points from `i` on.
HWY_INLINE Float3 specularOf(const Rows& ofPoints, const SurfaceWave& s, std::size_t i) {
    const Float3 specular = ofPoints.get(&MaterialRow::specular);
    return s.tint.x == nullptr ? specular : specular * loadAt(s.tint, i);
}

/// Glossy reflectance: k_s times the Phong lobe, zero where there is none.
template <bool area>
HWY_INLINE Float3 glossyReflectance(const MaterialRow* rows, const SurfaceWave& s, std::size_t i, Mask glossy,
                                    const LightSample<Float>& arriving, Float3 normal, Float3 toViewer,
                                    Float cosine) {
    const Float3 mirrored = normal * (2.0F * cosine) - arriving.toLight;
    const Float lobe = dot(mirrored, toViewer);
    const Mask seen = glossy & (lobe > 0.0F);
    if (none(seen)) return {};
    const Rows ofPoints(rows, s.material + i, seen);
    Float shininess = ofPoints.get(&MaterialRow::shininess);
    Float scale = ofPoints.get(&MaterialRow::lobeScale);
    if constexpr (area) widenLobe(arriving.spread, shininess, scale);
    const Float reflected = phongLobe(select(seen, lobe, 1.0F), shininess, scale);
    return selectOrZero(seen, specularOf(ofPoints, s, i) * reflected);
}

/// Reflectance of the rough lobe; zero where there is none.
HWY_INLINE Float3 roughReflectance(const MaterialRow* rows, const SurfaceWave& s, std::size_t i, Mask rough,
                                   Float toLight, Float toViewer) {
    const Rows ofPoints(rows, s.material + i, rough);
    const Float reflected = roughLobe(toLight, toViewer, ofPoints.get(&MaterialRow::roughScale));
    return selectOrZero(rough, specularOf(ofPoints, s, i) * reflected);
}

/// What is left of the gloss for a light that mirrored rays see.
HWY_INLINE Float besideMirror(Uint traits, Float alpha) {
    return 1.0F - selectOrZero(hasTrait(traits, traits::kSharp), fadedMirror<Float>(sqrt(alpha)));
}

/// Reflectance of the gloss of points of the metallic-roughness model; zero of others. `mirrored`: mirrored
/// rays see the light.
template <bool area>
HWY_INLINE Float3 metallicReflectance(const SurfaceWave& s, std::size_t i, Mask metallic,
                                      const LightSample<Float>& arriving, Float3 normal, bool mirrored) {
    Float alpha = load(s.alpha + i);
    if constexpr (area) alpha = widenedAlpha<Float>(alpha, arriving.spread);
    const Float3 viewer = liftedViewer<Float>(loadAt(s.toViewer, i), normal);
    const GgxScattering<Float> gloss = scatterGgx<Float>(normal, viewer, arriving.toLight, alpha);
    const Float3 factor =
        glossFactor<Float>(loadAt(s.straight, i), loadAt(s.grazing, i), gloss.fresnelCosine);
    const Float wide = furtherFactor<Float>(loadAt(s.furtherShape, i), dot(normal, viewer),
                                            dot(normal, arriving.toLight), dot(viewer, arriving.toLight));
    Float lobe = gloss.lobe;
    if (mirrored) lobe = lobe * besideMirror(load(s.traits + i), load(s.alpha + i));
    return selectOrZero(metallic, factor * lobe + loadAt(s.further, i) * (wide * kLambertLobe));
}

/// A rectangle that mirrors show is sampled as the surface gets its light, with less noise. The others keep
/// the samples by area that scenes of before have.
template <LightKind kind, bool area>
HWY_INLINE LightSample<Float> sampleOf(const Light& light, Float3 position, Float3 normal,
                                       const Stratum<Float>& stratum, bool mirrored) {
    if constexpr (kind == LightKind::Rectangle && area) {
        if (mirrored) {
            const LightDraw<Float> draw =
                sampleRectangleForSurface<Float>(light, position, normal, stratum.u, stratum.v);
            const Float solidAngle = selectOrZero(draw.density > 0.0F, 1.0F / draw.density);
            return {draw.toLight, draw.free, draw.irradiance * stratum.weight,
                    solidAngle * (stratum.ofAll / kPi)};
        }
    }
    return sampleLight<kind>(light, position, stratum);
}

/// `area`: it has a size, to which highlights are widened.
template <LightKind kind, bool area>
HWY_INLINE std::size_t lightAll(const Light& light, const LightStrata* strata, const MaterialRow* rows,
                                const SurfaceWave& s, const ShadowArrays* shadows,
                                const KnownVisibility* known) {
    std::size_t count = 0;
    const bool mirrored = isMirrored(light);
    for (std::size_t i = 0; i < s.size(); i += lanes()) {
        const Uint traits = load(s.traits + i);
        Mask lit = hasTrait(traits, traits::kPoint);
        if (known != nullptr) lit = without(lit, hasTrait(load(known->dark + i), known->bit));
        if (none(lit)) {
            storeAt(Float3{}, s.added, i);
            continue;
        }
        const Float3 position = loadAt(s.position, i);
        const Float3 normal = loadAt(s.shadingNormal, i);
        const LightSample<Float> arriving = sampleOf<kind, area>(
            light, position, normal, strataOf<kind>(strata, i), mirrored && strata != nullptr);
        const Float3 geometricNormal = loadAt(s.geometricNormal, i);
        const Float geometric = dot(geometricNormal, arriving.toLight);
        const Float cosine = dot(normal, arriving.toLight);
        lit = lit & ((geometric > 0.0F) & (cosine > 0.0F));
        if (none(lit)) {
            storeAt(Float3{}, s.added, i);
            continue;
        }
        Float3 weight = loadAt(s.diffuse, i);
        const Mask glossy = lit & hasTrait(traits, traits::kGlossy);
        const Mask rough = lit & hasTrait(traits, traits::kRough);
        if (any(glossy | rough)) {
            const Float3 toViewer = loadAt(s.toViewer, i);
            if (any(glossy)) {
                weight += glossyReflectance<area>(rows, s, i, glossy, arriving, normal, toViewer, cosine);
            }
            if (any(rough)) weight += roughReflectance(rows, s, i, rough, cosine, dot(normal, toViewer));
        }
        const Mask metallic = lit & hasTrait(traits, traits::kMetallic);
        if (any(metallic)) weight += metallicReflectance<area>(s, i, metallic, arriving, normal, mirrored);
        weight *= cosine * terminatorFactor<Float>(geometricNormal, normal, geometric, cosine);
        const Float3 added = selectOrZero(lit, loadAt(s.weight, i) * weight * arriving.irradiance);
        storeAt(added, s.added, i);
        if (shadows == nullptr) continue;

        lit = without(lit, isZero(added));
        if (known != nullptr) lit = without(lit, hasTrait(load(known->clear + i), known->bit));
        const Compressor some(lit);
        const Float clearance = load(s.clearance + i);
        storeAt(position + geometricNormal * clearance, some, shadows->origin, count);
        storeAt(arriving.toLight, some, shadows->direction, count);
        some.store(max(arriving.free - clearance, 0.0F), shadows->tMax + count);
        some.store(iota(i), shadows->point + count);
        count += some.count();
    }
    return count;
}

/// Returns the number of shadow rays.
std::size_t lightSurfaces(const Light& light, const LightStrata* strata, const MaterialRow* rows,
                          const SurfaceWave& surfaces, const ShadowArrays* shadows,
                          const KnownVisibility* known) {
    return forKind(light.kind, [&]<LightKind kind>() HWY_ATTR {
        if constexpr (traitsOf(kind).disc) {
            if (isDisc(light)) return lightAll<kind, true>(light, strata, rows, surfaces, shadows, known);
        }
        return lightAll<kind, isAreaLight(kind)>(light, strata, rows, surfaces, shadows, known);
    });
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(lightSurfaces);

namespace {

void addLight(const Light& light, const LightStrata* strata, const MaterialTable& materials,
              SurfaceWave& surfaces, ShadowRays* shadows, const KnownVisibility* known) {
    if (shadows == nullptr) {
        HWY_DYNAMIC_DISPATCH(lightSurfaces)(light, strata, materials.rows(), surfaces, nullptr, nullptr);
        return;
    }
    RayWave& rays = shadows->rays;
    const std::size_t room = surfaces.size() + kWaveBlock;
    rays.resize(room);
    if (shadows->point.size() < room) shadows->point.resize(room);
    const ShadowArrays arrays{rays.origins(), rays.directions(), rays.tMax.data(), shadows->point.data()};
    rays.resize(
        HWY_DYNAMIC_DISPATCH(lightSurfaces)(light, strata, materials.rows(), surfaces, &arrays, known));
}

} // namespace

void addLight(const Light& light, const MaterialTable& materials, SurfaceWave& surfaces, ShadowRays* shadows,
              const KnownVisibility* known) {
    addLight(light, nullptr, materials, surfaces, shadows, known);
}

void addLight(const Light& light, const LightStrata& strata, const MaterialTable& materials,
              SurfaceWave& surfaces, ShadowRays* shadows, const KnownVisibility* known) {
    addLight(light, &strata, materials, surfaces, shadows, known);
}

} // namespace rtcore
#endif
