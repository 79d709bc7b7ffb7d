#include "rtcore/pathtracing/scatter_wave.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/pathtracing/scatter_wave.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/pathtracing/path_lobes-inl.h"
#include "rtcore/pathtracing/path_numbers-inl.h"
#include "rtcore/shading/paths/path_length-inl.h"

#ifndef RTCORE_PATHTRACING_SCATTER_WAVE_TYPES
#define RTCORE_PATHTRACING_SCATTER_WAVE_TYPES
namespace rtcore {

/// Arrays of a PathBatch, from some ray on.
struct BatchArrays {
    ArraysOf3 origin, direction, weight, extinction;
    std::uint32_t *sample, *bounces, *state, *cell;
    float *length, *total, *density;
    ArraysOf3 point, normal;
    std::uint32_t* media[2]; ///< null: none
};

struct ScatterRows {
    const MaterialRow* materials;
    PathNames names;
    const LightSamples* samples;
    const float* distance; ///< of the hits
    PathSettings limits;
    std::uint32_t maxDepth;
    bool anyToHit; ///< paths that have scattered often enough may still find light
};

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// The path up to each point.
struct Past {
    Uint sample, bounces, state;
    Float length{};
    Float3 extinction{};
};
HWY_INLINE Past pastOf(const BatchArrays* paths, std::uint32_t first, std::size_t i) {
    if (paths == nullptr) return {iota(first + i), Uint(0U), Uint(0U), Float(0), Float3{}};
    return {load(paths->sample + i), load(paths->bounces + i), load(paths->state + i),
            load(paths->length + i), loadAt(paths->extinction, i)};
}

/// The chance that paths of these weights go on: as the root, so that those that do grow weaker from bounce
/// to bounce. Below the least, weights would grow too much. (docs/lab/paths.md)
HWY_INLINE Float survival(Float3 weight) { return clamp<Float>(sqrt(maxComponent(weight)), 0.05F, 1.0F); }

/// The first of `count` values, as many as there are.
HWY_INLINE Float loadDistances(const float* values, std::size_t count) {
    return count >= lanes() ? load(values) : loadSome(values, count);
}

/// Returns how many rays were appended.
std::size_t scatterAll(const ScatterRows& rows, const SurfaceWave& s, const BatchArrays* paths,
                       const BatchArrays& next) {
    std::size_t count = 0;
    const auto maxScatters = static_cast<std::int32_t>(rows.limits.bounces) + (rows.anyToHit ? 1 : 0);
    for (std::size_t i = 0; i < s.size(); i += lanes()) {
        const Mask points = hasTrait(load(s.traits + i), traits::kPoint);
        if (none(points)) continue;
        const Past past = pastOf(paths, rows.names.first, i);
        const Uint scatters = past.state & Uint(path_state::kScatters);
        // A path that has scattered once more than it may only looks for lights: in mirrors, too, where what
        // they show counts.
        const auto max = static_cast<std::int32_t>(rows.limits.bounces + 1);
        const Mask within = toInt(scatters) < max;
        const Mask looking = without(toInt(scatters) < max + (rows.anyToHit ? 1 : 0), within);
        const Mask matte = (past.state & Uint(path_state::kMatte)) != Uint(0U);
        const Mask shown = rows.limits.caustics ? looking : without(looking, matte);
        const Mask open = points & (within | shown);
        if (none(open)) continue;
        const PointNormals normals = normalsAt(s, i);
        const PointLobes lobes = lobesOf(rows.materials, s, i, open, normals);
        const MirrorChoice mirror = mirrorChoiceOf(lobes);
        if (none(mirror.possible)) continue;
        const PathName name = pathName(rows.names, paths == nullptr ? nullptr : paths->sample, i, open);
        const Visit<Uint> visit = visitOf(scatters, past.bounces);
        const PathNumbers lobe = numbersFor(name, SampleDimension::Lobe, visit);
        const PathNumbers numbers = numbersFor(name, SampleDimension::Direction, visit);
        const BsdfSample sample = sampleBsdf(lobes, mirror, lobe.u, {numbers.u, numbers.v});

        // Mirrored: the weight of mirrored light over the chance of it.
        const Mask mirrored = sample.mirrored & (toInt(past.bounces & Uint(0xFFFFU)) <
                                                 static_cast<std::int32_t>(rows.maxDepth));
        const Mask scattered = without(mirror.possible & (toInt(scatters) < maxScatters), sample.mirrored);
        const Scattered light = scatteredFrom(lobes, mirror, sample.direction);
        const Mask kept = scattered & (light.density > 0.0F);
        const Float3 lobeWeight = loadAt(s.weight, i) * light.value / select(kept, light.density, Float(1));
        const Float3 mirrorWeight = loadAt(s.specular, i) / select(mirrored, mirror.probability, Float(1));
        Float3 weight = select(mirrored, mirrorWeight, lobeWeight);
        Mask going = (mirrored | kept) & (maxComponent(weight) > 0.0F) & isFinite(maxComponent(weight));

        // Russian roulette, never for a mirror.
        const Mask risky = without(going & !(toInt(scatters) < rows.limits.rouletteFrom), mirrored);
        const Float chance = select(risky, survival(weight), Float(1));
        going = going & (lobe.v < chance);
        if (none(going)) continue;
        weight = weight / select(going, chance, Float(1));

        const Compressor some(going);
        const Float3 normal = normals.geometric;
        const Float3 origin = loadAt(s.position, i) + normal * load(s.clearance + i);
        const Float distance = loadDistances(rows.distance + i, s.size() - i);
        const Mask flat = mirrored & isFlat<Float>(normals.shading, normal);
        storeAt(origin, some, next.origin, count);
        storeAt(sample.direction, some, next.direction, count);
        storeAt(weight, some, next.weight, count);
        storeAt(past.extinction, some, next.extinction, count);
        some.store(past.sample, next.sample + count);
        some.store(select(mirrored, past.bounces + 1U, past.bounces), next.bounces + count);
        some.store(lengthAfter(past.length, distance, flat), next.length + count);
        // After a mirror next event does not count; where light of matte surfaces comes by one
        // it is a caustic.
        const Uint afterMatte =
            past.state | Uint(rows.limits.caustics ? path_state::kWhole : path_state::kDropped);
        const Uint afterMirror = select(matte, afterMatte, past.state);
        const Uint afterLobe = (scatters + 1U) | selectOrZero(sample.matte, Uint(path_state::kMatte));
        some.store(select(mirrored, afterMirror, afterLobe), next.state + count);
        storeAt(origin, some, next.point, count);
        storeAt(normals.shading, some, next.normal, count);
        if (rows.samples != nullptr) {
            some.store(load(rows.samples->total + i), next.total + count);
            some.store(load(rows.samples->cell + i), next.cell + count);
        }
        some.store(selectOrZero(kept, light.density), next.density + count);
        for (int k = 0; k < 2 && next.media[k] != nullptr; ++k)
            some.store(paths != nullptr && paths->media[k] != nullptr ? load(paths->media[k] + i) : Uint(0U),
                       next.media[k] + count);
        count += some.count();
    }
    return count;
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(scatterAll);

namespace {

BatchArrays arraysOf(PathBatch& batch, std::size_t first) {
    PathQueue& queue = batch.queue;
    const ScatterState& state = batch.scattered();
    return {queue.rays.origins().from(first),
            queue.rays.directions().from(first),
            queue.weights().from(first),
            queue.extinctions().from(first),
            queue.sample.data() + first,
            queue.bounces.data() + first,
            state.state + first,
            state.cell + first,
            queue.length.data() + first,
            state.total + first,
            state.density + first,
            state.point.from(first),
            state.normal.from(first),
            {queue.mediaFrom(0, first), queue.mediaFrom(1, first)}};
}

} // namespace

void scatterPaths(const ScatterTask& task, const Wave& wave, PathBatch* paths, PathBatch& next) {
    PathQueue& queue = next.queue;
    const std::size_t before = queue.grow(wave.size() + kWaveBlock);
    if (paths != nullptr && paths->queue.hasMedia()) queue.keepMedia();
    const ScatterRows rows{task.materials.rows(), task.names,    task.samples,          wave.hits.t.data(),
                           task.limits,           task.maxDepth, task.lights.anyToHit()};
    BatchArrays old{};
    if (paths != nullptr) old = arraysOf(*paths, 0);
    const std::size_t count = HWY_DYNAMIC_DISPATCH(scatterAll)(
        rows, wave.surfaces, paths != nullptr ? &old : nullptr, arraysOf(next, before));
    queue.truncate(before + count);
}

} // namespace rtcore
#endif
