#include "rtcore/kernels/wave_kernels.h"

#include "rtcore/kernels/hit_distance.h"
#include "rtcore/kernels/single_ray.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

// Compiled once for each instruction set, and the best chosen when the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/kernels/wave_kernels.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/kernels/wave-inl.h"

#include <hwy/highway.h>

#ifndef RTCORE_KERNELS_WAVE_KERNELS_ONCE
#define RTCORE_KERNELS_WAVE_KERNELS_ONCE
namespace rtcore {
namespace {

bool isFiltered(const KernelScene& scene) { return !scene.filter.empty() || scene.clear != nullptr; }

} // namespace
} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

std::size_t nearHits(const RaySpan& rays, const HitSpan& hits, float limit, std::uint32_t* indices) {
    const hn::ScalableTag<float> d;
    const std::size_t lanes = hn::Lanes(d);
    std::size_t found = 0;
    const auto add = [&](std::size_t i) {
        indices[found] = static_cast<std::uint32_t>(i);
        const bool hit = hits.triangle[i] != kNoTriangle;
        found += hit && isNear(rays.ray(i), {hits.t[i], 0, 0, 0}, limit) ? 1 : 0;
    };
    std::size_t i = 0;
    for (; i + lanes <= rays.count; i += lanes) {
        const auto t = hn::LoadU(d, hits.t + i);
        const auto x = hn::LoadU(d, rays.direction[0] + i);
        const auto y = hn::LoadU(d, rays.direction[1] + i);
        const auto z = hn::LoadU(d, rays.direction[2] + i);
        const auto squared = hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
        const auto isClose = hn::Lt(hn::Mul(hn::Mul(t, t), squared), hn::Set(d, limit * limit));
        if (hn::AllFalse(d, isClose)) continue;
        for (std::size_t k = i; k < i + lanes; ++k) add(k);
    }
    for (; i < rays.count; ++i) add(i);
    return found;
}

std::size_t tiedHits(const HitSpan& hits, std::size_t count, std::uint32_t* indices) {
    const hn::ScalableTag<std::int32_t> d;
    const std::size_t lanes = hn::Lanes(d);
    std::size_t found = 0;
    const auto add = [&](std::size_t i) {
        const std::uint32_t triangle = hits.triangle[i];
        indices[found] = static_cast<std::uint32_t>(i);
        found += triangle != kNoTriangle && (triangle & kTiedHit) != 0 ? 1 : 0;
    };
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes) {
        const auto triangle = hn::LoadU(d, reinterpret_cast<const std::int32_t*>(hits.triangle) + i);
        if (hn::AllTrue(d, hn::Gt(triangle, hn::Set(d, -2)))) continue;
        for (std::size_t k = i; k < i + lanes; ++k) add(k);
    }
    for (; i < count; ++i) add(i);
    return found;
}

#if HWY_TARGET == HWY_SCALAR

void closest(const KernelScene& scene, const RaySpan& rays, StreamScratch& /*scratch*/, const HitSpan& hits) {
    for (std::size_t i = 0; i < rays.count; ++i) {
        Hit hit;
        findNearest(scene, rays.ray(i), hit);
        hits.t[i] = hit.t;
        hits.u[i] = hit.u;
        hits.v[i] = hit.v;
        hits.triangle[i] = hit.triangle;
    }
}

void any(const KernelScene& scene, const RaySpan& rays, StreamScratch& /*scratch*/, std::uint8_t* occluded) {
    // Single rays do not keep what they pass.
    const std::uint8_t none = scene.clear == nullptr ? 0 : 2;
    for (std::size_t i = 0; i < rays.count; ++i) occluded[i] = findAny(scene, rays.ray(i)) ? 1 : none;
}

#else

void closest(const KernelScene& scene, const RaySpan& rays, StreamScratch& scratch, const HitSpan& hits) {
    if (isFiltered(scene)) {
        traverseWave<Search{false, true}>(scene, rays, scratch, ClosestOutput{hits});
    } else {
        traverseWave<Search{false, false}>(scene, rays, scratch, ClosestOutput{hits});
    }
}

void any(const KernelScene& scene, const RaySpan& rays, StreamScratch& scratch, std::uint8_t* occluded) {
    if (isFiltered(scene)) {
        traverseWave<Search{true, true}>(scene, rays, scratch, AnyOutput{occluded});
    } else {
        traverseWave<Search{true, false}>(scene, rays, scratch, AnyOutput{occluded});
    }
}

#endif

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(closest);
HWY_EXPORT(any);
HWY_EXPORT(nearHits);
HWY_EXPORT(tiedHits);

void traceClosest(const KernelScene& scene, const RaySpan& rays, StreamScratch& scratch,
                  const HitSpan& hits) {
    HWY_DYNAMIC_DISPATCH(closest)(scene, rays, scratch, hits);
}

void traceAny(const KernelScene& scene, const RaySpan& rays, StreamScratch& scratch, std::uint8_t* occluded) {
    HWY_DYNAMIC_DISPATCH(any)(scene, rays, scratch, occluded);
}

std::size_t findTied(const HitSpan& hits, std::size_t count, std::uint32_t* indices) {
    return HWY_DYNAMIC_DISPATCH(tiedHits)(hits, count, indices);
}

std::size_t findNear(const RaySpan& rays, const HitSpan& hits, float limit, std::uint32_t* indices) {
    return HWY_DYNAMIC_DISPATCH(nearHits)(rays, hits, limit, indices);
}

} // namespace rtcore
#endif
