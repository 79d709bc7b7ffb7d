#include "rtcore/shading/mirror_wave.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/shading/mirror_wave.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/scattering/fresnel-inl.h"
#include "rtcore/shading/paths/path_length-inl.h"
#include "rtcore/shading/surface/material_rows-inl.h"

#ifndef RTCORE_SHADING_MIRROR_WAVE_TYPES
#define RTCORE_SHADING_MIRROR_WAVE_TYPES
namespace rtcore {

/// Arrays of a PathQueue, from some ray on.
struct PathArrays {
    std::uint32_t *sample, *bounces;
    ArraysOf3 weight, extinction;
    float* length;
    std::uint32_t* media[2]; ///< null: none
};
struct RayArrays {
    ArraysOf3 origin, direction;
};
struct MirrorLimits {
    std::uint32_t maxDepth;
    float minContribution;
    bool discs; ///< FrameContext::discs
};

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// The first of `count` values, as many as there are.
HWY_INLINE Float loadFew(const float* values, std::size_t count) {
    if (count >= lanes()) return load(values);
    float some[kLanes] = {};
    std::copy_n(values, count, some);
    return load(some);
}

/// Marks rays that are mirrored where a lobe of the metallic-roughness model is asked about discs, too.
HWY_INLINE Uint markedLobes(const SurfaceWave& s, std::size_t i, Mask specular, Uint bounces) {
    const Mask metallic = specular & hasTrait(load(s.traits + i), traits::kMetallic);
    if (none(metallic)) return bounces;
    const Mask asked = metallic & (maxComponent(loadAt(s.straight, i) + loadAt(s.grazing, i)) > 0.0F);
    return select(asked, bounces | Uint(kLobeBit), bounces);
}

/// Returns how many rays were appended. `distances` of the points along the wave's rays. `paths`: of the
/// points, null for primary rays.
std::size_t mirrorAll(const SurfaceWave& s, const float* distances, const PathArrays* paths,
                      MirrorLimits limits, const RayArrays& rays, const PathArrays& queue) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < s.size(); i += lanes()) {
        Mask specular = hasTrait(load(s.traits + i), traits::kSpecular);
        if (none(specular)) continue;
        const Float3 weight = loadAt(s.specular, i);
        const Float largest = maxComponent(weight);
        specular = specular & ((largest > 0.0F) & (largest >= limits.minContribution));
        Uint bounces = 0U;
        if (paths != nullptr) bounces = load(paths->bounces + i);
        specular = specular & (toInt(bounces & 0xFFFFU) < static_cast<std::int32_t>(limits.maxDepth));
        if (none(specular)) continue;

        const Compressor some(specular);
        const Float3 normal = loadAt(s.geometricNormal, i);
        const Float3 smooth = loadAt(s.shadingNormal, i);
        const Float3 mirrored = mirrorDirection<Float>(loadAt(s.toViewer, i), smooth, normal);
        storeAt(loadAt(s.position, i) + normal * load(s.clearance + i), some, rays.origin, count);
        storeAt(normalize(mirrored, specular), some, rays.direction, count);
        storeAt(weight, some, queue.weight, count);
        Uint sample = iota(i);
        Float3 extinction{};
        Float length = 0.0F;
        if (paths != nullptr) {
            sample = load(paths->sample + i);
            extinction = loadAt(paths->extinction, i);
            length = load(paths->length + i);
        }
        const Float distance = loadFew(distances + i, s.size() - i);
        const Mask flat = isFlat<Float>(smooth, normal);
        some.store(sample, queue.sample + count);
        Uint next = bounces + 1U;
        if (limits.discs) next = markedLobes(s, i, specular, next & Uint(~kLobeBit));
        some.store(next, queue.bounces + count);
        storeAt(extinction, some, queue.extinction, count);
        some.store(lengthAfter(length, distance, flat), queue.length + count);
        for (int k = 0; k < 2 && queue.media[k] != nullptr; ++k)
            some.store(paths != nullptr && paths->media[k] != nullptr ? load(paths->media[k] + i) : Uint(0U),
                       queue.media[k] + count);
        count += some.count();
    }
    return count;
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(mirrorAll);

namespace {

PathArrays pathsFrom(PathQueue& queue, std::size_t first) {
    return {queue.sample.data() + first, queue.bounces.data() + first,
            queue.weights().from(first), queue.extinctions().from(first),
            queue.length.data() + first, {queue.mediaFrom(0, first), queue.mediaFrom(1, first)}};
}

} // namespace

void addMirroredRays(const FrameContext& frame, const Wave& wave, PathQueue& queue) {
    const RenderSettings& settings = *frame.settings;
    const SurfaceWave& surfaces = wave.surfaces;
    PathQueue* const paths = wave.paths.past();
    const std::size_t before = queue.grow(surfaces.size() + kWaveBlock);
    if (paths != nullptr && paths->hasMedia()) queue.keepMedia();
    const RayArrays to{queue.rays.origins().from(before), queue.rays.directions().from(before)};
    const PathArrays newPaths = pathsFrom(queue, before);
    const MirrorLimits limits{static_cast<std::uint32_t>(settings.maxDepth), settings.minContribution,
                              frame.discs};
    PathArrays old{};
    if (paths != nullptr) old = pathsFrom(*paths, 0);
    const std::size_t count = HWY_DYNAMIC_DISPATCH(mirrorAll)(
        surfaces, wave.hits.t.data(), paths != nullptr ? &old : nullptr, limits, to, newPaths);
    queue.truncate(before + count);
}

} // namespace rtcore
#endif
