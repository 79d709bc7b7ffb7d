#include "rtcore/pathtracing/next_event.h"

#include "rtcore/pathtracing/path_batch.h"
#include "rtcore/pathtracing/sampling_strategy.h"
#include "rtcore/shading/surface/surface.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/pathtracing/next_event.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/lights/emitters-inl.h"
#include "rtcore/lights/environment_sampler-inl.h"
#include "rtcore/lights/light_direction-inl.h"
#include "rtcore/pathtracing/light_selection-inl.h"
#include "rtcore/pathtracing/path_lobes-inl.h"
#include "rtcore/pathtracing/path_numbers-inl.h"
#include "rtcore/pathtracing/path_weights-inl.h"

#ifndef RTCORE_PATHTRACING_NEXT_EVENT_TYPES
#define RTCORE_PATHTRACING_NEXT_EVENT_TYPES
namespace rtcore {

/// Input of the next-event kernels, beside the surfaces.
struct NextEventRows {
    LightRows lights;
    EmitterRows emitters;
    EnvironmentRows surroundings;
    PathNames names;
    const std::uint32_t *sample, *bounces; ///< of PathQueue; null: of primary rays
    const std::uint32_t* scatters;         ///< null: none yet
    std::uint32_t maxScatters;
};

/// Where shadow rays and their light go (KeptLight), and of which paths they are.
struct NextEventRays {
    ArraysOf3 origin, direction;
    float* tMax;
    ArraysOf3 light;
    float* weight;
    std::uint32_t *sample, *group, *scatters;
    const std::uint32_t *sampleOf, *scattersOf; ///< as in NextEventRows, by point
    std::uint32_t first;                        ///< PathNames
};

/// Sampled points of emitters, as in Hit.
struct EmitterHits {
    std::uint32_t* triangle;
    float *u, *v;
};

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// A sample of the group that some lanes selected.
struct GroupSample {
    Float3 toLight{};
    Float3 irradiance{}; ///< of emitters and surroundings yet to be looked up
    Float free{}, density{};
};

HWY_INLINE GroupSample sampleOfLight(const Light& light, Float3 position, Float u, Float v) {
    return forKind(light.kind, [&]<LightKind kind>() HWY_ATTR {
        const LightDirectionSample<Float> sample = sampleLightDirection<kind, Float>(light, position, u, v);
        return GroupSample{sample.toLight, sample.irradiance, sample.free, sample.density};
    });
}

HWY_INLINE GroupSample sampleOfEmitters(const EmitterRows& rows, Float3 position, const PathNumbers& numbers,
                                        Uint bits, Uint cluster, const EmitterHits& hits, std::size_t i,
                                        Mask chosen) {
    const EmitterSample<Float> sample = sampleEmitter<Float>(rows, numbers.u, numbers.v, bits, cluster);
    const Float3 offset = sample.position - position;
    const Float distance = sqrt(dot(offset, offset));
    const Mask apart = chosen & (distance > 0.0F);
    const Float3 toLight = normalize(select(apart, offset, broadcast(Vec3{0, 1, 0})), apart);
    const Float density = bySolidAngle<Float>(sample.density, distance, dot(toLight, sample.normal));
    store(select(chosen, sample.triangle, load(hits.triangle + i)), hits.triangle + i);
    store(sample.u, hits.u + i);
    store(sample.v, hits.v + i);
    return {toLight, Float3{}, distance * 0.9999F, selectOrZero(apart & isFinite(density), density)};
}

HWY_INLINE GroupSample sampleOfSurroundings(const EnvironmentRows& rows, const VisibilityRows& visible,
                                            Uint cell, const PathNumbers& numbers) {
    const EnvironmentSample<Float> sample =
        sampleVisible(rows, visible, cell, numbers.bitsOfU, numbers.bitsOfV);
    return {sample.direction, Float3{}, std::numeric_limits<float>::max(), sample.density};
}

HWY_INLINE void take(GroupSample& all, Mask where, const GroupSample& some) {
    all.toLight = select(where, some.toLight, all.toLight);
    all.irradiance = select(where, some.irradiance, all.irradiance);
    all.free = select(where, some.free, all.free);
    all.density = select(where, some.density, all.density);
}

void sampleLights(const NextEventRows& rows, const SurfaceWave& s, const LightSamples& to,
                  const EmitterHits& hits) {
    for (std::size_t i = 0; i < s.size(); i += lanes()) {
        Mask used = hasTrait(load(s.traits + i), traits::kPoint);
        Visit<Uint> visit{0U, 0U};
        if (rows.scatters != nullptr) {
            const Uint scatters = load(rows.scatters + i) & Uint(path_state::kScatters);
            used = used & (toInt(scatters) < static_cast<std::int32_t>(rows.maxScatters + 1));
            visit = visitOf(scatters, load(rows.bounces + i));
        }
        if (none(used)) {
            store(Uint(LightSamples::kNone), to.group + i);
            store(Uint(0U), to.cell + i);
            continue;
        }
        const Float3 position = loadAt(s.position, i);
        const Float3 start = position + loadAt(s.geometricNormal, i) * load(s.clearance + i);
        const PathName name = pathName(rows.names, rows.sample, i, used);
        const PathNumbers choice = numbersFor(name, SampleDimension::Light, visit);
        const PathNumbers numbers = numbersFor(name, SampleDimension::AreaLight, visit);
        const ChosenLight chosen =
            chooseLight(rows.lights, start, loadAt(s.shadingNormal, i), choice.bitsOfU, choice.bitsOfV);
        GroupSample sample;
        Mask rest = used;
        while (any(rest)) {
            HWY_ALIGN std::uint32_t groups[kLanes];
            store(chosen.group, groups);
            const std::uint32_t group = groups[rest.first()];
            const Mask these = rest & (chosen.group == group);
            if (group < rows.lights.lights) {
                const Light& light = rows.lights.light[group];
                GroupSample one =
                    sampleOfLight(light, isAreaLight(light) ? start : position, numbers.u, numbers.v);
                one.density = selectOrZero(raysMeet(rows.lights, light, start), one.density);
                take(sample, these, one);
            } else if (group == rows.lights.emitterGroup()) {
                // A tree has used those bits.
                const Uint bits = rows.emitters.byTree()
                                      ? numbersFor(name, SampleDimension::Emitter, visit).bitsOfU
                                      : choice.bitsOfV;
                take(sample, these,
                     sampleOfEmitters(rows.emitters, start, numbers, bits, chosen.cluster, hits, i, these));
            } else {
                take(sample, these,
                     sampleOfSurroundings(rows.surroundings, rows.lights.visible, chosen.cell, numbers));
            }
            rest = without(rest, these);
        }
        const Float scale = 1.0F / select(used, chosen.probability, Float(1));
        store(select(used, chosen.group, Uint(LightSamples::kNone)), to.group + i);
        storeAt(sample.toLight, to.toLight, i);
        storeAt(sample.irradiance * scale, to.irradiance, i);
        store(sample.free, to.free + i);
        store(sample.density * chosen.probability, to.density + i);
        store(chosen.total, to.total + i);
        store(chosen.cell, to.cell + i);
    }
}

/// Returns the number of shadow rays.
std::size_t addSamples(const LightSamples& from, const MaterialRow* rows, SamplingStrategy strategy,
                       bool apart, const SurfaceWave& s, const NextEventRays& shadows) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < s.size(); i += lanes()) {
        const Mask used = hasTrait(load(s.traits + i), traits::kPoint) &
                          (load(from.group + i) != Uint(LightSamples::kNone));
        if (none(used)) continue;
        const PointNormals normals = normalsAt(s, i);
        const PointLobes lobes = lobesOf(rows, s, i, used, normals);
        const MirrorChoice mirror = mirrorChoiceOf(lobes);
        const Float3 toLight = loadAt(from.toLight, i);
        const Scattered scattered = scatteredFrom(lobes, mirror, toLight);
        const Float density = load(from.density + i);
        const Mask byBoth = used & (density > 0.0F) & (scattered.density > 0.0F);
        const Float weight = select(
            byBoth,
            misWeightOfNextEvent<Float>(strategy, select(byBoth, density, Float(1)), scattered.density),
            Float(1));
        Float3 added = loadAt(s.weight, i) * scattered.value * loadAt(from.irradiance, i);
        if (!apart) added = added * weight;
        const Mask lit = without(used, isZero(added));
        if (none(lit)) continue;
        const Compressor some(lit);
        const Float clearance = load(s.clearance + i);
        storeAt(loadAt(s.position, i) + normals.geometric * clearance, some, shadows.origin, count);
        storeAt(toLight, some, shadows.direction, count);
        some.store(max(load(from.free + i) - clearance, 0.0F), shadows.tMax + count);
        storeAt(added, some, shadows.light, count);
        some.store(weight, shadows.weight + count);
        some.store(load(from.group + i), shadows.group + count);
        const auto point = static_cast<std::uint32_t>(i);
        const bool primary = shadows.sampleOf == nullptr;
        some.store(primary ? iota(shadows.first + point) : load(shadows.sampleOf + i),
                   shadows.sample + count);
        some.store(primary ? Uint(0U) : load(shadows.scattersOf + i) & Uint(path_state::kScatters),
                   shadows.scatters + count);
        count += some.count();
    }
    return count;
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(sampleLights);
HWY_EXPORT(addSamples);

void NextEvents::resize(std::size_t count) {
    memory_.resize(9, count);
    const std::size_t room = count + kWaveBlock;
    if (group_.size() < room) {
        group_.resize(room);
        triangle_.resize(room);
        cell_.resize(room);
        u_.resize(room);
        v_.resize(room);
    }
    samples_ = {group_.data(),    memory_.arraysOf3(0), memory_.arraysOf3(3), memory_.array(6),
                memory_.array(7), memory_.array(8),     cell_.data()};
}

void NextEvents::sample(const NextEventTask& task, const Wave& wave) {
    resize(wave.size());
    const bool primary = wave.paths.primary();
    const NextEventRows rows{task.rows,
                             task.lights.emitters().rows(),
                             task.lights.surroundings().rows(),
                             task.names,
                             primary ? nullptr : wave.paths.queue()->sample.data(),
                             primary ? nullptr : wave.paths.queue()->bounces.data(),
                             task.scatters,
                             task.bounces};
    HWY_DYNAMIC_DISPATCH(sampleLights)
    (rows, wave.surfaces, samples_, {triangle_.data(), u_.data(), v_.data()});
    if (task.rows.emitters || task.rows.surroundings) lookUp(task, wave);
}

/// Looks up the radiance of emitters and surroundings in textures and images.
void NextEvents::lookUp(const NextEventTask& task, const Wave& wave) {
    for (std::size_t i = 0; i < wave.size(); ++i) {
        const std::uint32_t group = group_[i];
        if (group == LightSamples::kNone || group < task.rows.lights) continue;
        const float density = samples_.density[i];
        samples_.irradiance.set(i, density > 0 ? radianceOf(task, i) / density : Colour{});
    }
}

Colour NextEvents::radianceOf(const NextEventTask& task, std::size_t i) const {
    if (group_[i] == task.rows.emitterGroup())
        return emissionAt(task.scene, task.textures, {0, triangle_[i], u_[i], v_[i]});
    return task.lights.background().radiance(samples_.toLight.at(i));
}

void NextEvents::add(const NextEventTask& task, const MaterialTable& materials, const Wave& wave,
                     KeptLight& kept) const {
    const std::size_t at = kept.size();
    const PathQueue* const queue = wave.paths.queue();
    const NextEventRays arrays{kept.rays.origins().from(at),
                               kept.rays.directions().from(at),
                               kept.rays.tMax.data() + at,
                               kept.light.from(at),
                               kept.weight + at,
                               kept.sample + at,
                               kept.group + at,
                               kept.scatters + at,
                               queue != nullptr ? queue->sample.data() : nullptr,
                               task.scatters,
                               task.names.first};
    kept.added(HWY_DYNAMIC_DISPATCH(addSamples)(samples_, materials.rows(), task.strategy, task.apart,
                                                wave.surfaces, arrays));
}

} // namespace rtcore
#endif
