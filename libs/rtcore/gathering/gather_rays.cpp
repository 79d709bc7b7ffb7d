#include "rtcore/gathering/gather_rays.h"

#include "rtcore/platform/parts.h"
#include "rtcore/platform/threads.h"

#include <algorithm>
#include <array>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/gathering/gather_rays.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/math/float3-inl.h"
#include "rtcore/sampling/disc-inl.h"
#include "rtcore/sampling/owen-inl.h"

#ifndef RTCORE_GATHERING_GATHER_RAYS_TYPES
#define RTCORE_GATHERING_GATHER_RAYS_TYPES
namespace rtcore {

/// A number for each ray of a pass, with room for a whole vector behind them.
using OfPass = std::array<float, 2 * kPassRays>;

/// The position of a stratum along Morton's curve; `column`, `row`: 0..7.
inline std::size_t alongCurve(std::uint32_t column, std::uint32_t row) {
    const auto spread = [](std::uint32_t x) { return (x & 1U) | (x & 2U) << 1 | (x & 4U) << 2; };
    return spread(column) | spread(row) << 1;
}

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// Points of the unit square, one in each stratum, along the curve.
void passPoints(std::uint32_t name, std::uint32_t first, OfPass& u, OfPass& v) {
    OfPass us, vs;
    const auto use = useBits(SampleDimension::Direction, 0);
    for (std::size_t i = 0; i < kPassRays; i += lanes()) {
        const auto point = pointInSequence<Float>(Uint(name), iota(first + i), Uint(use));
        store(point.u, &us[i]);
        store(point.v, &vs[i]);
    }
    for (std::size_t i = 0; i < kPassRays; ++i) {
        const std::size_t at =
            alongCurve(static_cast<std::uint32_t>(us[i] * 8), static_cast<std::uint32_t>(vs[i] * 8));
        u[at] = us[i];
        v[at] = vs[i];
    }
}

void passDirections(Vec3 normal, std::uint32_t name, std::uint32_t first, const ArraysOf3& directions) {
    OfPass u, v;
    passPoints(name, first, u, v);
    const auto basis = rtcore::basisAround(normal);
    for (std::size_t i = 0; i < kPassRays; i += lanes()) {
        const Disc<Float> disc = onDisc<Float>(load(&u[i]), load(&v[i]));
        const Float up = sqrt(max(1.0F - (disc.x * disc.x + disc.y * disc.y), 1e-8F));
        storeAt(broadcast(basis.tangent) * disc.x + broadcast(basis.bitangent) * disc.y +
                    broadcast(normal) * up,
                directions, i);
    }
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(passDirections);

void addGatherRays(const GatherPass& pass, RayWave& rays) {
    OfPass x, y, z;
    const auto first = pass.number * static_cast<std::uint32_t>(kPassRays);
    HWY_DYNAMIC_DISPATCH(passDirections)(pass.normal, pass.name, first, {x.data(), y.data(), z.data()});
    for (std::size_t i = 0; i < kPassRays; ++i)
        rays.push({pass.origin, 0, {x[i], y[i], z[i]}, std::numeric_limits<float>::max()});
}

namespace {

constexpr float kEndlessLength = 1e15F;

/// Long waves are quicker, but all threads have some of the few passes of a live frame.
std::size_t passesOfWave(std::size_t passes, int threads) {
    constexpr std::size_t kMin = 16, kMax = 128, kOfThread = 2;
    return std::clamp(passes / (kOfThread * static_cast<std::size_t>(threads)), kMin, kMax);
}

} // namespace

OutgoingCells::Site siteOf(const GatherScene& in, const Ray& ray, const Hit& hit) {
    const Vec3 normal = normalize(in.scene.mesh().geometricNormal(hit.triangle));
    const float length = std::min(hit.t, kEndlessLength);
    return {in.cells.levelOf(length), ray.origin + ray.direction * hit.t,
            dot(normal, ray.direction) > 0 ? -normal : normal, length, in.surfaces.of(hit.triangle)};
}

bool GatherHits::trace(const GatherScene& in, std::span<const GatherPass> passes, int threads,
                       const std::atomic<bool>* stop) {
    const std::size_t ofWave = passesOfWave(passes.size(), threadsFor(threads));
    const std::size_t count = passes.size() * kPassRays;
    sites_.resize(count);
    directions_.resize(count);
    const auto stopped = [&] { return stop != nullptr && stop->load(std::memory_order_relaxed); };
    struct Scratch {
        RayWave rays;
        HitWave hits;
    };
    forEachPart((passes.size() + ofWave - 1) / ofWave, threadsFor(threads), [&](std::size_t part) {
        if (stopped()) return;
        thread_local Scratch scratch;
        const std::size_t first = part * ofWave, last = std::min(first + ofWave, passes.size());
        scratch.rays.clear();
        for (std::size_t i = first; i < last; ++i) addGatherRays(passes[i], scratch.rays);
        in.tracer.intersect(RayKind::Scattered, scratch.rays, scratch.hits);
        for (std::size_t i = 0; i < scratch.rays.size(); ++i) {
            const std::size_t to = first * kPassRays + i;
            const Ray ray = scratch.rays.ray(i);
            directions_[to] = ray.direction;
            sites_[to] = scratch.hits.isHit(i)
                             ? siteOf(in, ray, scratch.hits.hit(i))
                             : OutgoingCells::Site{OutgoingCells::kNowhere, {}, {}, kEndlessLength, 0};
        }
    });
    return !stopped();
}

Ray GatherHits::ray(std::size_t ray, std::span<const GatherPass> passes) const {
    return {passes[ray / kPassRays].origin, 0, directions_[ray], std::numeric_limits<float>::max()};
}

} // namespace rtcore
#endif
