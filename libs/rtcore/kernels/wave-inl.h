// Whole waves: groups of 64 rays go as packets where their directions agree, the others as streams. Included
// once for each target.
#if defined(RTCORE_KERNELS_WAVE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_KERNELS_WAVE_INL_H_
#undef RTCORE_KERNELS_WAVE_INL_H_
#else
#define RTCORE_KERNELS_WAVE_INL_H_
#endif

#include "rtcore/kernels/bundle_tracer-inl.h"
#include "rtcore/kernels/packet_tracer-inl.h"
#include "rtcore/kernels/stream-inl.h"

#include <algorithm>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// The last rays of a wave, filled up to a whole group by the first of them.
struct LastGroup {
    LastGroup(const RaySpan& rays, std::size_t first) {
        const float* from[8] = {rays.origin[0],    rays.origin[1],    rays.origin[2], rays.direction[0],
                                rays.direction[1], rays.direction[2], rays.tMin,      rays.tMax};
        for (std::size_t c = 0; c < 8; ++c) {
            for (std::size_t i = 0; i < kGroup; ++i) {
                values[c][i] = from[c][first + i < rays.count ? first + i : first];
            }
        }
        span = {{values[0], values[1], values[2]},
                {values[3], values[4], values[5]},
                values[6],
                values[7],
                kGroup};
    }
    alignas(64) float values[8][kGroup];
    RaySpan span;
};

/// `Output` stores what a packet or a stream's slots hold.
template <Search kSearch, typename Output>
HWY_INLINE void traverseWave(const KernelScene& scene, const RaySpan& rays, StreamScratch& scratch,
                             Output&& output) {
    constexpr std::size_t kFewest = 512 / kGroup; // below, packets are faster whatever the directions
    PacketTracer<kSearch> packets(scene, rays);
    std::conditional_t<kSearch.any, NoBundles, BundleTracer<kSearch, std::remove_reference_t<Output>>>
        bundles(scene, rays, output);
    const auto asPacket = [&](const GroupShape& shape, std::size_t first) HWY_ATTR {
        packets.trace(shape, first, kGroup);
        output.fromPacket(packets.packet, first, kGroup);
    };
    const auto asStream = [&]() HWY_ATTR {
        scratch.makeRoom(scratch.groupCount * kGroup);
        StreamWalk<kSearch> stream(scene, scratch);
        stream.run(rays);
        for (std::size_t g = 0; g < scratch.groupCount; ++g) output.fromSlots(scratch, g);
        scratch.groupCount = 0;
    };
    scratch.groupCount = 0;
    const std::size_t whole = rays.count / kGroup * kGroup;
    for (std::size_t first = 0; first < whole; first += kGroup) {
        const GroupShape shape = shapeOf(rays, first);
        if (shape.coherent()) {
            if (!bundles.take(shape, first, scratch.bundleChoice, asPacket)) asPacket(shape, first);
            continue;
        }
        scratch.groups[scratch.groupCount++] = static_cast<std::uint32_t>(first);
        if (scratch.groupCount == StreamScratch::kRays / kGroup) asStream();
    }
    bundles.finish(scratch.bundleChoice);
    if (scratch.groupCount >= kFewest) {
        asStream();
    } else {
        for (std::size_t g = 0; g < scratch.groupCount; ++g)
            asPacket(shapeOf(rays, scratch.groups[g]), scratch.groups[g]);
    }
    if (whole == rays.count) return;
    const LastGroup last(rays, whole);
    PacketTracer<kSearch> tracer(scene, last.span);
    tracer.trace(shapeOf(last.span, 0), 0, rays.count - whole);
    output.fromPacket(tracer.packet, whole, rays.count - whole);
}

struct ClosestOutput {
    const HitSpan& hits;

    template <typename P>
    HWY_INLINE void fromPacket(const P& p, std::size_t first, std::size_t count) const {
        store(p.best, p.triangle, p.v, p.w, p.det, first, count);
    }
    HWY_INLINE void fromSlots(const StreamScratch& s, std::size_t group) const {
        const std::size_t at = group * kGroup;
        store(s.best + at, s.triangle + at, s.v + at, s.w + at, s.det + at, s.groups[group], kGroup);
    }

  private:
    HWY_INLINE void store(const float* best, const std::int32_t* triangle, const float* v, const float* w,
                          const float* det, std::size_t first, std::size_t count) const {
        const FloatTag d;
        const IntTag di;
        for (std::size_t i = 0; i < count; i += kLanes) {
            const Floats area = hn::Load(d, det + i);
            const Ints known = hn::Load(di, triangle + i);
            const Ints index = hn::IfThenElse(hn::Eq(known, hn::Set(di, kNone)), hn::Set(di, -1), known);
            const Floats weight1 = hn::Div(hn::Load(d, v + i), area);
            const Floats weight2 = hn::Div(hn::Load(d, w + i), area);
            const Floats t = hn::Load(d, best + i);
            const auto out = reinterpret_cast<std::int32_t*>(hits.triangle + first + i);
            if (i + kLanes <= count) {
                hn::StoreU(t, d, hits.t + first + i);
                hn::StoreU(weight1, d, hits.u + first + i);
                hn::StoreU(weight2, d, hits.v + first + i);
                hn::StoreU(index, di, out);
            } else {
                const Mask some = hn::FirstN(d, count - i);
                hn::BlendedStore(t, some, d, hits.t + first + i);
                hn::BlendedStore(weight1, some, d, hits.u + first + i);
                hn::BlendedStore(weight2, some, d, hits.v + first + i);
                hn::BlendedStore(index, hn::RebindMask(di, some), di, out);
            }
        }
    }
};

struct AnyOutput {
    std::uint8_t* occluded;

    HWY_INLINE void fromPacket(const Packet<kGroupVectors>& p, std::size_t first, std::size_t count) const {
        if (HWY_LIKELY(count == kGroup)) {
            store(p.best, p.triangle, occluded + first);
            return;
        }
        std::uint8_t all[kGroup];
        store(p.best, p.triangle, all);
        std::copy_n(all, count, occluded + first);
    }
    HWY_INLINE void fromSlots(const StreamScratch& s, std::size_t group) const {
        const std::size_t slot = group * kGroup;
        store(s.best + slot, s.triangle + slot, occluded + s.groups[group]);
    }

  private:
    /// Stores for a group: 1 for rays that were stopped, 2 for those that passed through something, else 0.
    static HWY_INLINE void store(const float* best, const std::int32_t* triangle, std::uint8_t* to) {
        const FloatTag d;
        const IntTag di;
        const hn::Rebind<std::uint8_t, IntTag> d8;
        for (std::size_t i = 0; i < kGroup; i += kLanes) {
            const Mask stopped = hn::Lt(hn::Load(d, best + i), hn::Zero(d));
            const auto passed = hn::Ne(hn::Load(di, triangle + i), hn::Set(di, kNone));
            const Ints found = hn::IfThenElse(hn::RebindMask(di, stopped), hn::Set(di, 1),
                                              hn::IfThenElseZero(passed, hn::Set(di, 2)));
            hn::StoreU(hn::DemoteTo(d8, found), d8, to + i);
        }
    }
};

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
