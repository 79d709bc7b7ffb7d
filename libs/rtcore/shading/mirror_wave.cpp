#include "rtcore/shading/mirror_wave.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/shading/mirror_wave.cpp"
#define HWY_DISABLED_TARGETS HWY_SSSE3
#include <hwy/foreach_target.h>
// The loop over targets comes before the code that is compiled for each of them.
#include "rtcore/shading/vector_materials-inl.h"

#ifndef RTCORE_SHADING_MIRROR_WAVE_TYPES
#define RTCORE_SHADING_MIRROR_WAVE_TYPES
namespace rtcore {

/// Arrays of a PathQueue, from some ray on.
struct PathArrays {
    std::uint32_t *sample, *bounces;
    ArraysOf3 weight, extinction;
};
struct RayArrays {
    ArraysOf3 origin, direction;
};
struct MirrorLimits {
    std::uint32_t maxDepth;
    float minContribution;
};

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

HWY_INLINE Vectors loadAt(const ArraysOf3& arrays, std::size_t i) {
    return loadVectors(arrays.x + i, arrays.y + i, arrays.z + i);
}
HWY_INLINE void storeAt(Vectors v, const ArraysOf3& arrays, std::size_t i) {
    storeVectors(v, arrays.x + i, arrays.y + i, arrays.z + i);
}

/// shading/fresnel.h
HWY_INLINE Floats schlickFades(Floats cosine) {
    const Floats x = hn::Sub(constant(1), smaller(larger(cosine, constant(0)), constant(1)));
    return hn::Mul(hn::Mul(hn::Mul(hn::Mul(x, x), x), x), x);
}

/// shading/surface_split.h, of opaque mirrors
void splitAll(const MaterialRow* rows, const SurfaceWave& s, const ArraysOf3* glow) {
    const FloatTag d;
    const BitsTag du;
    const Vectors white = constant(1, 1, 1);
    for (std::size_t i = 0; i < s.size(); i += hn::Lanes(d)) {
        const Bits traits = hn::LoadU(du, s.traits + i);
        const Lanes mirrors = hasTrait(traits, traits::kMirror);
        if (hn::AllFalse(d, mirrors)) continue;
        const Rows row(rows, s.material + i, mirrors);
        Vectors mirrored = row.get(&MaterialRow::mirror);
        const Lanes fresnel = hn::And(mirrors, hasTrait(traits, traits::kFresnel));
        if (!hn::AllFalse(d, fresnel)) {
            const Floats cosine = larger(dot(loadAt(s.toViewer, i), loadAt(s.shadingNormal, i)), constant(0));
            mirrored = select(fresnel, mirrored + (white - mirrored) * schlickFades(cosine), mirrored);
        }
        mirrored = mirrored * row.get(&MaterialRow::mirrorScale);
        const Vectors scattered = white - mirrored;
        const Vectors weight = loadAt(s.share, i);
        storeAt(select(mirrors, weight * mirrored, loadAt(s.onward, i)), s.onward, i);
        storeAt(select(mirrors, weight * scattered, weight), s.share, i);
        const Bits onward = hn::Or(traits, hn::Set(du, traits::kOnward));
        hn::StoreU(hn::BitCast(du, hn::IfThenElse(mirrors, hn::BitCast(d, onward), hn::BitCast(d, traits))),
                   du, s.traits + i);
        if (glow == nullptr) continue;
        const Vectors own =
            weight * (row.get(&MaterialRow::emission) + row.get(&MaterialRow::ambient) * scattered);
        storeAt(select(mirrors, own, loadAt(*glow, i)), *glow, i);
    }
}

HWY_INLINE Vectors mirrorDirections(Vectors toViewer, Vectors shadingNormal, Vectors geometricNormal,
                                    Lanes used) {
    const Floats lowest = constant(1e-3F);
    const Floats twice = hn::Mul(constant(2), dot(toViewer, shadingNormal));
    const Vectors mirrored = shadingNormal * twice - toViewer;
    const Floats height = dot(mirrored, geometricNormal);
    const Vectors bent = mirrored + geometricNormal * hn::Sub(lowest, height);
    return normalize(select(hn::Lt(height, lowest), bent, mirrored), used);
}

HWY_INLINE void storeSome(Vectors v, Lanes lanes, const ArraysOf3& to, std::size_t at) {
    storeAt({hn::Compress(v.x, lanes), hn::Compress(v.y, lanes), hn::Compress(v.z, lanes)}, to, at);
}
HWY_INLINE void storeSome(Bits v, Lanes lanes, std::uint32_t* to) {
    const FloatTag d;
    hn::StoreU(hn::BitCast(BitsTag(), hn::Compress(hn::BitCast(d, v), lanes)), BitsTag(), to);
}

/// Returns how many rays were appended. `paths`: of the points, null for primary rays.
std::size_t spawnAll(const SurfaceWave& s, const PathArrays* paths, MirrorLimits limits,
                     const RayArrays& rays, const PathArrays& queue) {
    const FloatTag d;
    const BitsTag du;
    const hn::RebindToSigned<FloatTag> di;
    const Bits lane = hn::Iota(du, 0);
    std::size_t count = 0;
    for (std::size_t i = 0; i < s.size(); i += hn::Lanes(d)) {
        Lanes onward = hasTrait(hn::LoadU(du, s.traits + i), traits::kOnward);
        if (hn::AllFalse(d, onward)) continue;
        const Vectors weight = loadAt(s.onward, i);
        const Floats largest = larger(weight.x, larger(weight.y, weight.z));
        onward = hn::And(
            onward, hn::And(hn::Gt(largest, constant(0)), hn::Ge(largest, constant(limits.minContribution))));
        Bits bounces = hn::Zero(du);
        if (paths != nullptr) bounces = hn::LoadU(du, paths->bounces + i);
        const auto depth = hn::BitCast(di, hn::And(bounces, hn::Set(du, 0xFFFFU)));
        const auto shallow = hn::Lt(depth, hn::Set(di, static_cast<std::int32_t>(limits.maxDepth)));
        onward = hn::And(onward, hn::MaskFromVec(hn::BitCast(d, hn::VecFromMask(di, shallow))));
        if (hn::AllFalse(d, onward)) continue;

        const Vectors normal = loadAt(s.geometricNormal, i);
        const Vectors origin = loadAt(s.position, i) + normal * hn::LoadU(d, s.clearance + i);
        storeSome(origin, onward, rays.origin, count);
        storeSome(mirrorDirections(loadAt(s.toViewer, i), loadAt(s.shadingNormal, i), normal, onward), onward,
                  rays.direction, count);
        storeSome(weight, onward, queue.weight, count);
        Bits sample = hn::Add(lane, hn::Set(du, static_cast<std::uint32_t>(i)));
        Vectors extinction = constant(0, 0, 0);
        if (paths != nullptr) {
            sample = hn::LoadU(du, paths->sample + i);
            extinction = loadAt(paths->extinction, i);
        }
        storeSome(sample, onward, queue.sample + count);
        storeSome(hn::Add(bounces, hn::Set(du, 1U)), onward, queue.bounces + count);
        storeSome(extinction, onward, queue.extinction, count);
        count += hn::CountTrue(d, onward);
    }
    return count;
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(splitAll);
HWY_EXPORT(spawnAll);

namespace {

PathArrays pathsFrom(PathQueue& queue, std::size_t first) {
    const auto arrays = [first](std::vector<float>(&values)[3]) {
        return ArraysOf3{values[0].data() + first, values[1].data() + first, values[2].data() + first};
    };
    return {queue.sample.data() + first, queue.bounces.data() + first, arrays(queue.weight),
            arrays(queue.extinction)};
}

} // namespace

void splitAtMirrors(const MaterialTable& materials, const SurfaceWave& surfaces, const ArraysOf3* glow) {
    HWY_DYNAMIC_DISPATCH(splitAll)(materials.rows(), surfaces, glow);
}

void spawnMirrored(const SurfaceWave& surfaces, PathQueue* paths, const RenderSettings& settings,
                   PathQueue& queue) {
    const std::size_t before = queue.grow(surfaces.size() + kWaveBlock);
    RayWave& rays = queue.rays;
    const RayArrays to{{&rays.ox[before], &rays.oy[before], &rays.oz[before]},
                       {&rays.dx[before], &rays.dy[before], &rays.dz[before]}};
    const PathArrays newPaths = pathsFrom(queue, before);
    const MirrorLimits limits{static_cast<std::uint32_t>(settings.maxDepth), settings.minContribution};
    PathArrays old{};
    if (paths != nullptr) old = pathsFrom(*paths, 0);
    const std::size_t count =
        HWY_DYNAMIC_DISPATCH(spawnAll)(surfaces, paths != nullptr ? &old : nullptr, limits, to, newPaths);
    queue.truncate(before + count);
}

} // namespace rtcore
#endif
