#include "rtcore/pathtracing/light_hits.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/pathtracing/light_hits.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/lights/environment_sampler-inl.h"
#include "rtcore/lights/light_direction-inl.h"
#include "rtcore/pathtracing/light_selection-inl.h"
#include "rtcore/pathtracing/path_weights-inl.h"
#include "rtcore/shading/surface/material_rows-inl.h"

#ifndef RTCORE_PATHTRACING_LIGHT_HITS_TYPES
#define RTCORE_PATHTRACING_LIGHT_HITS_TYPES
namespace rtcore {

/// The rays of a batch and what they hit.
struct HitRays {
    const RayWave& rays;
    const float* distance;       ///< to the surface
    const std::uint32_t* traits; ///< 0: none is hit
    ArraysOf3 weight;
};

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// Behind the rays of a batch lie cells of whatever was there before.
HWY_INLINE Uint cellAt(const VisibilityRows& visible, const ScatterState& s, std::size_t i) {
    const Int cell = toInt(load(s.cell + i));
    return toUint(selectOrZero(cell < Int(visible.cells), cell));
}

/// Weighted radiance of one light where rays meet it. `from`, `to`: the unoccluded part of the rays' lines.
HWY_INLINE Float3 lightMet(const LightRows& rows, SamplingStrategy strategy, std::uint32_t k,
                           const ScatterState& s, std::size_t i, Float3 direction, Float from, Float to) {
    const Light& light = rows.light[k];
    return forKind(light.kind, [&]<LightKind kind>() HWY_ATTR {
        if constexpr (!isAreaLight(kind)) {
            return Float3{};
        } else {
            const Float3 point = loadAt(s.point, i);
            const Float distance = hitLight<kind, Float>(light, point, direction);
            const Float density = load(s.density + i);
            // As far as shadow rays go: surfaces within the light do not occlude it.
            const Mask met = raysMeet(rows, light, point) & (density > 0.0F) & (distance >= from) &
                             (distance * 0.9999F <= to) & isFinite(distance);
            if (none(met)) return Float3{};
            const Float sampled =
                lightDirectionDensity<kind, Float>(light, point, direction, select(met, distance, Float(1)));
            const Float probability = probabilityOfLight<Float>(
                rows, k, point, loadAt(s.normal, i), cellAt(rows.visible, s, i), load(s.total + i));
            const Float weight = misWeightOfScatteredRay<Float>(strategy, select(met, density, Float(1)),
                                                                select(met, sampled * probability, Float(0)));
            // From inside of a sphere light next event samples one half of all directions alone.
            return selectOrZero(met & (sampled > 0.0F), broadcast(radianceOf<kind>(light)) * weight);
        }
    });
}

/// As many of the elements from `i` on as there are.
HWY_INLINE Float loadRest(const float* values, std::size_t i, std::size_t count) {
    return i + lanes() <= count ? load(values + i) : loadSome(values + i, count - i);
}

void meetLights(const LightRows& rows, SamplingStrategy strategy, const ScatterState& s, const HitRays& hits,
                const ArraysOf3& added) {
    const RayWave& rays = hits.rays;
    const std::size_t count = rays.size();
    const auto rest = [&](const std::vector<float>& values, std::size_t i)
                          HWY_ATTR { return loadRest(values.data(), i, count); };
    for (std::size_t i = 0; i < count; i += lanes()) {
        Float3 sum{};
        const Mask used = load(s.density + i) > 0.0F;
        if (any(used)) {
            const Float3 direction{rest(rays.dx, i), rest(rays.dy, i), rest(rays.dz, i)};
            const Float3 origin{rest(rays.ox, i), rest(rays.oy, i), rest(rays.oz, i)};
            const Float3 travelled = origin - loadAt(s.point, i);
            const Float from = sqrt(dot(travelled, travelled));
            const Mask hit = hasTrait(load(hits.traits + i), traits::kPoint);
            const Float to = select(hit, from + loadRest(hits.distance, i, count),
                                    Float(std::numeric_limits<float>::max()));
            const auto meet = [&](std::uint32_t k) HWY_ATTR {
                if (isAreaLight(rows.light[k].kind))
                    sum += lightMet(rows, strategy, k, s, i, direction, from, to);
            };
            if (rows.byTree()) {
                forLightsNear(rows.tree, loadAt(s.point, i), direction, used, meet);
            } else {
                for (std::uint32_t k = 0; k < rows.lights; ++k) meet(k);
            }
            sum = selectOrZero(used, sum * loadAt(hits.weight, i));
        }
        storeAt(sum, added, i);
    }
}

void densitiesOf(const EnvironmentRows& surroundings, const VisibilityRows& visible, const ScatterState& s,
                 const RayWave& rays, const std::uint32_t* traits, float* densities) {
    const std::size_t count = rays.size();
    for (std::size_t i = 0; i < count; i += lanes()) {
        if (none(load(traits + i) == Uint(0U))) continue;
        const Float3 direction{loadRest(rays.dx.data(), i, count), loadRest(rays.dy.data(), i, count),
                               loadRest(rays.dz.data(), i, count)};
        store(visibleDensity<Float>(surroundings, visible, cellAt(visible, s, i), direction), densities + i);
    }
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

namespace plain = HWY_NAMESPACE;

HWY_EXPORT(meetLights);
HWY_EXPORT(densitiesOf);

void addLightHits(const LightRows& lights, SamplingStrategy strategy, PathBatch& batch, Wave& wave) {
    PathQueue& queue = batch.queue;
    const HitRays hits{*wave.rays, wave.hits.t.data(), wave.surfaces.traits, queue.weights()};
    HWY_DYNAMIC_DISPATCH(meetLights)(lights, strategy, batch.scattered(), hits, wave.surfaces.contribution);
}

void densitiesOfEscaped(const EnvironmentRows& surroundings, const VisibilityRows& visible,
                        const PathBatch& batch, const Wave& wave, float* densities) {
    HWY_DYNAMIC_DISPATCH(densitiesOf)
    (surroundings, visible, batch.scattered(), *wave.rays, wave.surfaces.traits, densities);
}

Colour discSeen(const Light& light, Vec3 direction) {
    if (!isDisc(light) || !plain::meetsDisc<float>(light, direction)) return {};
    return plain::radianceOf<LightKind::Directional>(light);
}

float densityOfDisc(const LightRows& lights, const PathBatch& batch, std::size_t i, std::uint32_t k) {
    const ScatterState& s = batch.scattered();
    const Vec3 point = s.point.at(i), direction = batch.queue.rays.ray(i).direction;
    const float sampled =
        plain::lightDirectionDensity<LightKind::Directional, float>(lights.light[k], point, direction, 0);
    return sampled *
           plain::probabilityOfLight<float>(lights, k, point, s.normal.at(i), s.cell[i], s.total[i]);
}

float probabilityOfEmitters(const LightRows& lights, const PathBatch& batch, std::size_t i,
                            std::uint32_t cluster) {
    if (!lights.emitters) return 0;
    const ScatterState& s = batch.scattered();
    return plain::probabilityOfEmitters<float>(lights, cluster, s.point.at(i), s.normal.at(i), s.cell[i],
                                               s.total[i]);
}

float probabilityOfSurroundings(const LightRows& lights, const PathBatch& batch, std::size_t i) {
    if (!lights.surroundings) return 0;
    const ScatterState& s = batch.scattered();
    return plain::probabilityOfSurroundings<float>(lights, s.cell[i], s.total[i]);
}

} // namespace rtcore
#endif
