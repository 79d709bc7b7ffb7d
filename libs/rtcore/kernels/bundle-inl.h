// A bundle: packets of one origin that walk the tree together, as beams. A lane is a packet here, not a ray:
// no ray has an interval of its own, and what a packet as a whole cannot enter, none of its rays can. In
// leaves, beams of 16 rays are held against each triangle before any ray is. So rays meet more leaves than
// they would alone and fewer triangles, and find the same. Included once for each target.
#if defined(RTCORE_KERNELS_BUNDLE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_KERNELS_BUNDLE_INL_H_
#undef RTCORE_KERNELS_BUNDLE_INL_H_
#else
#define RTCORE_KERNELS_BUNDLE_INL_H_
#endif

#include "rtcore/kernels/beam-inl.h"
#include "rtcore/kernels/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

constexpr std::size_t kBundle = 16; ///< packets

/// A packet of a bundle, and what its rays have found: one array for each component.
struct BundledPacket {
    static constexpr std::size_t kRays = 64, kBeams = 4, kBeamRays = kRays / kBeams;
    static_assert(kBeamRays % kLanes == 0);

    alignas(64) float sx[kRays], sy[kRays], minusSz[kRays]; ///< ShearedRays
    alignas(64) float tMin[kRays];
    alignas(64) float best[kRays];
    alignas(64) std::int32_t triangle[kRays];
    alignas(64) float v[kRays], w[kRays], det[kRays];
    Beam beams[kBeams];
    std::size_t first; ///< the index of its first ray
    AlongAxis along;
};

/// Packets of one origin and one octant of directions.
class Bundle {
  public:
    /// Lanes without a packet must not become NaN, which min() forgets.
    Bundle() {
        for (auto* const inverses : {inverseLo, inverseHi}) {
            for (int axis = 0; axis < 3; ++axis) std::fill_n(inverses[axis], kBundle, 1.0F);
        }
        std::fill_n(reach, kBundle, -1.0F);
    }

    std::size_t size = 0;
    Vec3 origin;
    bool negative[3] = {}; ///< by axis: directions point down it
    BundledPacket packets[kBundle];
    /// By packet. Along the axes signs are taken out: all directions count as positive.
    alignas(64) float inverseLo[3][kBundle], inverseHi[3][kBundle];
    alignas(64) float begin[kBundle], end[kBundle]; ///< of the interval in the root's cell
    alignas(64) float reach[kBundle];               ///< nothing further away matters to any ray
    alignas(64) float slack[kBundle];

    /// Whether a packet of this origin and these signs can join.
    bool suits(Vec3 from, const bool (&signs)[3]) const {
        return from == origin && std::equal(signs, signs + 3, negative);
    }
};

template <Search kSearch>
class BundleWalk {
  public:
    BundleWalk(const KernelScene& scene, Bundle& bundle) : scene_(scene), bundle_(bundle) {}

    /// Finds what the rays of all packets hit.
    HWY_NOINLINE void run() {
        const FloatTag d;
        Lanes begin, end;
        for (std::size_t k = 0; k < kVectors; ++k) {
            begin.of[k] = hn::Load(d, bundle_.begin + k * kLanes);
            end.of[k] = hn::Load(d, bundle_.end + k * kLanes);
        }
        const KdNode* const nodes = scene_.nodes;
        std::size_t waiting = 0;
        std::uint32_t index = 0;
        while (true) {
            const KdNode node = nodes[index];
            if (!node.isLeaf()) {
                index = descend(node, begin, end, waiting);
                continue;
            }
            if (node.count() != 0) testLeaf({scene_, node}, begin, end);
            bool alive = false;
            do {
                if (waiting == 0) return;
                alive = take(stack_[--waiting], begin, end);
            } while (!alive);
            index = stack_[waiting].node;
        }
    }

  private:
    static constexpr std::size_t kVectors = kBundle / kLanes;
    static constexpr std::size_t kBeamVectors = BundledPacket::kBeamRays / kLanes;

    struct Lanes {
        Floats of[kVectors];
    };
    struct WaitingBundle {
        alignas(64) float begin[kBundle], end[kBundle];
        std::uint32_t node;
    };

    /// The next node; leaves the intervals of its cell in `begin` and `end`.
    HWY_INLINE std::uint32_t descend(KdNode node, Lanes& begin, Lanes& end, std::size_t& waiting) {
        const FloatTag d;
        const int axis = node.axis();
        const bool negative = bundle_.negative[axis];
        const float ahead = negative ? bundle_.origin[axis] - node.split : node.split - bundle_.origin[axis];
        const std::uint32_t near = node.lowerChild() + (negative ? 1 : 0),
                            far = node.lowerChild() + (negative ? 0 : 1);
        const Floats distance = hn::Set(d, ahead);
        Lanes nearEnd, farBegin;
        Mask entersNear = hn::FirstN(d, 0), entersFar = hn::FirstN(d, 0);
        for (std::size_t k = 0; k < kVectors; ++k) {
            const Floats p = hn::Mul(distance, hn::Load(d, bundle_.inverseLo[axis] + k * kLanes));
            const Floats q = hn::Mul(distance, hn::Load(d, bundle_.inverseHi[axis] + k * kLanes));
            farBegin.of[k] = hn::Max(begin.of[k], hn::Mul(hn::Min(p, q), hn::Set(d, kPlaneDown)));
            nearEnd.of[k] = hn::Min(end.of[k], hn::Mul(hn::Max(p, q), hn::Set(d, kPlaneUp)));
            entersNear = hn::Or(entersNear, hn::Le(begin.of[k], nearEnd.of[k]));
            entersFar = hn::Or(entersFar, hn::Le(farBegin.of[k], end.of[k]));
        }
        if (hn::AllFalse(d, entersFar)) return near;
        if (hn::AllFalse(d, entersNear)) {
            begin = farBegin;
            return far;
        }
        const KdNode child = scene_.nodes[far];
        if (!(child.isLeaf() && child.count() == 0)) {
            WaitingBundle& entry = stack_[waiting++];
            entry.node = far;
            if (child.isLeaf()) {
                sendForLeaf(scene_, child);
            } else {
                hwy::Prefetch(scene_.nodes + child.lowerChild());
            }
            for (std::size_t k = 0; k < kVectors; ++k) {
                hn::Store(farBegin.of[k], d, entry.begin + k * kLanes);
                hn::Store(end.of[k], d, entry.end + k * kLanes);
            }
        }
        end = nearEnd;
        return near;
    }

    /// Takes over the intervals that waited, cut at what was hit since; false when no packet is left.
    HWY_INLINE bool take(const WaitingBundle& entry, Lanes& begin, Lanes& end) const {
        const FloatTag d;
        Mask alive = hn::FirstN(d, 0);
        for (std::size_t k = 0; k < kVectors; ++k) {
            begin.of[k] = hn::Load(d, entry.begin + k * kLanes);
            end.of[k] = hn::Min(hn::Load(d, entry.end + k * kLanes), hn::Load(d, bundle_.reach + k * kLanes));
            alive = hn::Or(alive, hn::Le(begin.of[k], end.of[k]));
        }
        return !hn::AllFalse(d, alive);
    }

    HWY_INLINE void testLeaf(const Leaf& leaf, const Lanes& begin, const Lanes& end) {
        for (std::uint32_t i = 0; i < leaf.common; i += SeenTriangles::kMax) {
            const SeenTriangles triangles(scene_, leaf, i, leaf.common, bundle_.origin);
            forEachAlive(begin, end, [&](std::size_t p) HWY_ATTR { testPacket(triangles, p); });
        }
        if (HWY_UNLIKELY(leaf.common < leaf.count)) testNarrow(leaf, begin, end);
    }

    HWY_NOINLINE void testNarrow(const Leaf& leaf, const Lanes& begin, const Lanes& end) {
        for (std::uint32_t i = leaf.common; i < leaf.count; i += SeenTriangles::kMax) {
            const SeenTriangles triangles(scene_, leaf, i, leaf.count, bundle_.origin);
            forEachAlive(begin, end, [&](std::size_t p) HWY_ATTR {
                const BundledPacket& packet = bundle_.packets[p];
                testBeams(triangles, p, [&](std::uint32_t which, std::size_t at, Found& found) HWY_ATTR {
                    testNarrowTriangles<kSearch>(scene_, leaf, i, which, packet.along,
                                                 shearedRays(packet, at),
                                                 hn::Load(FloatTag(), packet.tMin + at), allLanes(), found);
                });
            });
        }
    }

    template <typename Work>
    HWY_INLINE void forEachAlive(const Lanes& begin, const Lanes& end, const Work& work) const {
        for (std::size_t k = 0; k < kVectors; ++k)
            forEachLane(hn::Le(begin.of[k], end.of[k]),
                        [&](std::size_t lane) HWY_ATTR { work(k * kLanes + lane); });
    }

    HWY_NOINLINE void testPacket(const SeenTriangles& triangles, std::size_t p) {
        const FloatTag d;
        const BundledPacket& packet = bundle_.packets[p];
        const AlongAxis along = packet.along;
        testBeams(triangles, p, [&](std::uint32_t which, std::size_t at, Found& found) HWY_ATTR {
            const ShearedRays rays = shearedRays(packet, at);
            const Floats tMin = hn::Load(d, packet.tMin + at);
            for (; which != 0; which &= which - 1) {
                const auto i = static_cast<std::size_t>(std::countr_zero(which));
                if (isHidden<kSearch>(scene_, triangles.triangle[i])) continue;
                const auto offset = [&](std::size_t c) HWY_ATTR {
                    return Offset{hn::Set(d, triangles.offsets(c, along.kx)[i]),
                                  hn::Set(d, triangles.offsets(c, along.ky)[i]),
                                  hn::Set(d, triangles.offsets(c, along.kz)[i])};
                };
                Outcome outcome = edgeTest(offset(0), offset(1), offset(2), rays);
                filter<kSearch>(scene_, triangles.triangle[i], tMin, allLanes(), found, outcome);
                keepHits<kSearch>(outcome, triangles.triangle[i], tMin, allLanes(), found);
            }
        });
    }

    /// Calls `test` for each vector of the packet whose beam may meet some of the triangles, with a bit for
    /// each of these, and keeps what its rays find.
    template <typename Test>
    HWY_INLINE void testBeams(const SeenTriangles& triangles, std::size_t p, const Test& test) {
        BundledPacket& packet = bundle_.packets[p];
        std::uint32_t candidates[BundledPacket::kBeams];
        findCandidates<true>(triangles, packet.along, packet.beams, candidates);
        const Floats tie = hn::Set(FloatTag(), bundle_.slack[p] * kTieFraction);
        Mask changed = hn::FirstN(FloatTag(), 0);
        for (std::size_t b = 0; b < BundledPacket::kBeams; ++b) {
            if (candidates[b] == 0) continue;
            for (std::size_t k = 0; k < kBeamVectors; ++k) {
                const std::size_t at = b * BundledPacket::kBeamRays + k * kLanes;
                Found found = foundSoFar(packet, tie, at);
                test(candidates[b], at, found);
                keep(found, packet, at);
                changed = hn::Or(changed, found.changed);
            }
        }
        if (!hn::AllFalse(FloatTag(), changed)) measureReach(p);
    }

    HWY_INLINE static Mask allLanes() { return hn::FirstN(FloatTag(), kLanes); }

    HWY_INLINE ShearedRays shearedRays(const BundledPacket& packet, std::size_t at) const {
        const FloatTag d;
        const Vec3 from = bundle_.origin;
        return {hn::Set(d, from[packet.along.kx]), hn::Set(d, from[packet.along.ky]),
                hn::Set(d, from[packet.along.kz]), hn::Load(d, packet.sx + at),
                hn::Load(d, packet.sy + at),       hn::Load(d, packet.minusSz + at)};
    }
    HWY_INLINE static Found foundSoFar(const BundledPacket& packet, Floats tie, std::size_t at) {
        const FloatTag d;
        return {hn::Load(d, packet.best + at),
                hn::Load(IntTag(), packet.triangle + at),
                hn::Load(d, packet.v + at),
                hn::Load(d, packet.w + at),
                hn::Load(d, packet.det + at),
                hn::FirstN(d, 0),
                hn::FirstN(d, 0),
                tie};
    }
    HWY_INLINE static void keep(const Found& found, BundledPacket& packet, std::size_t at) {
        const FloatTag d;
        hn::Store(found.best, d, packet.best + at);
        hn::Store(found.triangle, IntTag(), packet.triangle + at);
        hn::Store(found.v, d, packet.v + at);
        hn::Store(found.w, d, packet.w + at);
        hn::Store(found.det, d, packet.det + at);
    }

    HWY_INLINE void measureReach(std::size_t p) {
        const FloatTag d;
        const BundledPacket& packet = bundle_.packets[p];
        Floats max = hn::Load(d, packet.best);
        for (std::size_t at = kLanes; at < BundledPacket::kRays; at += kLanes)
            max = hn::Max(max, hn::Load(d, packet.best + at));
        bundle_.reach[p] = hn::GetLane(hn::MaxOfLanes(d, max)) + bundle_.slack[p];
    }

    const KernelScene& scene_;
    Bundle& bundle_;
    WaitingBundle stack_[kMaxKdDepth];
};

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
