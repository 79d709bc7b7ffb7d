#include "support/embree_waves.h"

#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "support/embree_waves.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace test {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <int N>
struct Packet;
template <>
struct Packet<4> {
    using Ray = RTCRay4;
    using RayHit = RTCRayHit4;
};
template <>
struct Packet<8> {
    using Ray = RTCRay8;
    using RayHit = RTCRayHit8;
};
template <>
struct Packet<16> {
    using Ray = RTCRay16;
    using RayHit = RTCRayHit16;
};

// Stores as wide as the loads that Embree does next: narrower ones would make it wait for them.
template <int N, typename T>
void copyAll(const T* from, T* to) {
    const hn::CappedTag<T, N> d;
    for (std::size_t i = 0; i < N; i += hn::Lanes(d)) hn::StoreU(hn::LoadU(d, from + i), d, to + i);
}

template <int N, typename T>
void fill(T value, T* to) {
    const hn::CappedTag<T, N> d;
    for (std::size_t i = 0; i < N; i += hn::Lanes(d)) hn::StoreU(hn::Set(d, value), d, to + i);
}

// All N, but for the packet at the end of the wave.
template <int N, typename T>
void copy(const T* from, T* to, std::size_t count) {
    if (count == N) {
        copyAll<N>(from, to);
    } else {
        for (std::size_t i = 0; i < count; ++i) to[i] = from[i];
    }
}

template <int N, typename Ray>
void load(const RayArrays& rays, std::size_t first, std::size_t count, Ray& packet, int* valid) {
    copy<N>(rays.ox + first, packet.org_x, count);
    copy<N>(rays.oy + first, packet.org_y, count);
    copy<N>(rays.oz + first, packet.org_z, count);
    copy<N>(rays.tMin + first, packet.tnear, count);
    copy<N>(rays.dx + first, packet.dir_x, count);
    copy<N>(rays.dy + first, packet.dir_y, count);
    copy<N>(rays.dz + first, packet.dir_z, count);
    copy<N>(rays.tMax + first, packet.tfar, count);
    for (std::size_t i = count; i < N; ++i) valid[i] = 0;
}

template <int N>
void intersectPackets(RTCScene scene, EmbreeQuery& query, const RayArrays& rays, const HitArrays& hits) {
    typename Packet<N>::RayHit packet{};
    alignas(64) int valid[N];
    fill<N>(-1, valid);
    fill<N>(0xFFFFFFFFU, packet.ray.mask);
    for (std::size_t first = 0; first < rays.count; first += N) {
        const std::size_t count = HWY_MIN(std::size_t{N}, rays.count - first);
        load<N>(rays, first, count, packet.ray, valid);
        fill<N>(RTC_INVALID_GEOMETRY_ID, packet.hit.geomID);
        fill<N>(RTC_INVALID_GEOMETRY_ID, packet.hit.primID);
        query.intersect(valid, scene, packet);
        copy<N>(packet.ray.tfar, hits.t + first, count);
        copy<N>(packet.hit.u, hits.u + first, count);
        copy<N>(packet.hit.v, hits.v + first, count);
        copy<N>(packet.hit.primID, hits.triangle + first, count);
    }
}

template <int N>
void occludedPackets(RTCScene scene, EmbreeQuery& query, const RayArrays& rays, std::uint8_t* occluded) {
    typename Packet<N>::Ray packet{};
    alignas(64) int valid[N];
    fill<N>(-1, valid);
    fill<N>(0xFFFFFFFFU, packet.mask);
    for (std::size_t first = 0; first < rays.count; first += N) {
        const std::size_t count = HWY_MIN(std::size_t{N}, rays.count - first);
        load<N>(rays, first, count, packet, valid);
        query.occluded(valid, scene, packet);
        for (std::size_t i = 0; i < count; ++i) occluded[first + i] = packet.tfar[i] < 0 ? 1 : 0;
    }
}

// Single rays are written a block ahead of their calls: Embree reads vectors where single numbers were
// stored, and would wait for stores that have only just been made.
constexpr std::size_t kAhead = 16;

void stage(const RayArrays& rays, std::size_t first, std::size_t count, RTCRay* staged) {
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = first + i;
        staged[i] = {rays.ox[at], rays.oy[at], rays.oz[at],   rays.tMin[at], rays.dx[at], rays.dy[at],
                     rays.dz[at], 0,           rays.tMax[at], 0xFFFFFFFFU,   0,           0};
    }
}

void intersectSingly(RTCScene scene, EmbreeQuery& query, const RayArrays& rays, const HitArrays& hits) {
    RTCRay staged[kAhead];
    RTCRayHit ray{};
    for (std::size_t first = 0; first < rays.count; first += kAhead) {
        const std::size_t count = HWY_MIN(kAhead, rays.count - first);
        stage(rays, first, count, staged);
        for (std::size_t i = 0; i < count; ++i) {
            ray.ray = staged[i];
            ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            ray.hit.primID = RTC_INVALID_GEOMETRY_ID;
            query.intersect(scene, ray);
            hits.t[first + i] = ray.ray.tfar;
            hits.u[first + i] = ray.hit.u;
            hits.v[first + i] = ray.hit.v;
            hits.triangle[first + i] = ray.hit.primID;
        }
    }
}

void occludedSingly(RTCScene scene, EmbreeQuery& query, const RayArrays& rays, std::uint8_t* occluded) {
    RTCRay staged[kAhead];
    for (std::size_t first = 0; first < rays.count; first += kAhead) {
        const std::size_t count = HWY_MIN(kAhead, rays.count - first);
        stage(rays, first, count, staged);
        for (std::size_t i = 0; i < count; ++i) {
            RTCRay ray = staged[i];
            query.occluded(scene, ray);
            occluded[first + i] = ray.tfar < 0 ? 1 : 0;
        }
    }
}

void intersectAny(RTCScene scene, EmbreeQuery& query, int width, const RayArrays& rays,
                  const HitArrays& hits) {
    switch (width) {
    case 16:
        return intersectPackets<16>(scene, query, rays, hits);
    case 8:
        return intersectPackets<8>(scene, query, rays, hits);
    case 4:
        return intersectPackets<4>(scene, query, rays, hits);
    default:
        return intersectSingly(scene, query, rays, hits);
    }
}

void occludedAny(RTCScene scene, EmbreeQuery& query, int width, const RayArrays& rays,
                 std::uint8_t* occluded) {
    switch (width) {
    case 16:
        return occludedPackets<16>(scene, query, rays, occluded);
    case 8:
        return occludedPackets<8>(scene, query, rays, occluded);
    case 4:
        return occludedPackets<4>(scene, query, rays, occluded);
    default:
        return occludedSingly(scene, query, rays, occluded);
    }
}

} // namespace HWY_NAMESPACE
} // namespace test
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace test {

HWY_EXPORT(intersectAny);
HWY_EXPORT(occludedAny);

void intersectWave(RTCScene scene, bool coherent, int width, const RayArrays& rays, const HitArrays& hits) {
    EmbreeQuery query(coherent);
    HWY_DYNAMIC_DISPATCH(intersectAny)(scene, query, width, rays, hits);
}

void occludedWave(RTCScene scene, bool coherent, int width, const RayArrays& rays, std::uint8_t* occluded) {
    EmbreeQuery query(coherent);
    HWY_DYNAMIC_DISPATCH(occludedAny)(scene, query, width, rays, occluded);
}

} // namespace test
#endif
