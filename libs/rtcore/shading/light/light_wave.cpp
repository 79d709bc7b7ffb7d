#include "rtcore/shading/light/light_wave.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/shading/light/light_wave.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/lights/light_sample-inl.h"
#include "rtcore/lights/rectangle_sample-inl.h"
#include "rtcore/shading/surface/faded_mirror-inl.h"
#include "rtcore/shading/surface/lobes-inl.h"

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

/// Fraction of the gloss that remains for a light that mirrored rays see.
HWY_INLINE Float besideMirror(Uint traits, Float alpha) {
    return 1.0F - selectOrZero(hasTrait(traits, traits::kSharp), fadedMirror<Float>(sqrt(alpha)));
}

/// A rectangle that mirrors show is sampled as the surface gets its light, with less noise. The others keep
/// the samples by area that scenes of before have.
template <LightKind kind, bool area>
HWY_INLINE LightSample<Float> sampleOf(const Light& light, Float3 position, Float3 normal,
                                       const Stratum<Float>& stratum, bool mirrored) {
    if constexpr (kind == LightKind::Rectangle && area) {
        if (mirrored) {
            const LightDirectionSample<Float> sample =
                sampleRectangleForSurface<Float>(light, position, normal, stratum.u, stratum.v);
            const Float solidAngle = selectOrZero(sample.density > 0.0F, 1.0F / sample.density);
            return {sample.toLight, sample.free, sample.irradiance * stratum.weight,
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
            storeAt(Float3{}, s.contribution, i);
            continue;
        }
        const Float3 position = loadAt(s.position, i);
        const PointNormals normals = normalsAt(s, i);
        const LightSample<Float> arriving = sampleOf<kind, area>(
            light, position, normals.shading, strataOf<kind>(strata, i), mirrored && strata != nullptr);
        const Incidence incidence = incidenceOf(normals, arriving.toLight);
        lit = lit & incidence.above;
        if (none(lit)) {
            storeAt(Float3{}, s.contribution, i);
            continue;
        }
        const PointLobes lobes = lobesOf(rows, s, i, lit, normals);
        Float metalLeft = 1.0F, coatLeft = 1.0F;
        if (mirrored && lobes.anyMetallic) metalLeft = besideMirror(traits, load(s.alpha + i));
        if (mirrored && lobes.anyCoated) coatLeft = besideMirror(traits, load(s.coatAlpha + i));
        const Float3 scattered = scatteredFrom<area, SumOrder::OfRays>(lobes, arriving.toLight, incidence,
                                                                       {arriving.spread, metalLeft, coatLeft})
                                     .value;
        const Float3 added = selectOrZero(lit, loadAt(s.weight, i) * scattered * arriving.irradiance);
        storeAt(added, s.contribution, i);
        if (shadows == nullptr) continue;

        lit = without(lit, isZero(added));
        if (known != nullptr) lit = without(lit, hasTrait(load(known->clear + i), known->bit));
        const Compressor some(lit);
        const Float clearance = load(s.clearance + i);
        storeAt(position + normals.geometric * clearance, some, shadows->origin, count);
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
