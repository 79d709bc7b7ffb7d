// A packet: a few vectors of rays that walk the tree together, each lane with its own interval of the node's
// cell. Lanes enter exactly the nodes that the single ray enters (single_ray.cpp), or more. Included once for
// each target.
#if defined(RTCORE_KERNELS_PACKET_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_KERNELS_PACKET_INL_H_
#undef RTCORE_KERNELS_PACKET_INL_H_
#else
#define RTCORE_KERNELS_PACKET_INL_H_
#endif

#include "rtcore/kernels/packet_leaves-inl.h"
#include "rtcore/kernels/rounding.h"

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// The bounds of a component over the rays of a packet.
struct Range {
    float lo, hi;
};

/// Decides for all rays of a packet at once whether they pass a plane before or behind their intervals, from
/// the ranges of their components alone (rounding is monotone, so the verdict holds for each ray).
class Culling {
  public:
    Range origin[3], inverse[3];
    bool uniform[3]; ///< all directions have the same sign on this axis, and none is zero
    std::uint32_t upperFirst[3];

    /// Bounds of (split - origin) * inverse.
    HWY_INLINE Range planes(int axis, float split) const {
        const float a = split - origin[axis].hi;
        const float b = split - origin[axis].lo;
        const float p = a * inverse[axis].lo;
        const float q = a * inverse[axis].hi;
        const float r = b * inverse[axis].lo;
        const float s = b * inverse[axis].hi;
        return {std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s))};
    }
    /// The same for one common origin.
    HWY_INLINE Range planesOfOrigin(int axis, float split) const {
        const float a = split - origin[axis].lo;
        const float p = a * inverse[axis].lo;
        const float q = a * inverse[axis].hi;
        return {std::min(p, q), std::max(p, q)};
    }
};

/// A child that waits, with the intervals of all rays in its cell.
template <std::size_t kVectors>
struct WaitingPacket {
    alignas(64) float t0[kVectors * kLanes], t1[kVectors * kLanes];
    std::uint32_t node;
    Range interval; ///< no ray's interval reaches beyond it
};

/// `kCull`: worth trying to decide for all rays at once.
template <std::size_t kVectors, Shared kShared, bool kCull, Search kSearch>
class PacketWalk {
  public:
    PacketWalk(const KernelScene& scene, Packet<kVectors>& packet)
        : leaves(scene, packet), scene_(scene), packet_(packet) {}

    /// Visits all leaves below `root` that any ray meets.
    HWY_NOINLINE void run(std::uint32_t root, const Culling& culling) {
        Floats t0[kVectors];
        Floats t1[kVectors];
        Place place{root, 0, {}};
        if (!enter(t0, t1, place)) return;
        while (findLeaf(culling, t0, t1, place)) {
            if (leaves.test({scene_, scene_.nodes[place.node]}, t0, t1)) return;
            if (!next(t0, t1, place)) return;
        }
    }

    /// The same in steps: begin(), then step() as long as there is a leaf to test. What the next step needs
    /// is on its way from memory in between. The culling must stay.
    HWY_NOINLINE bool begin(std::uint32_t root, const Culling& culling) {
        Floats t0[kVectors];
        Floats t1[kVectors];
        place_ = {root, 0, {}};
        return enter(t0, t1, place_) && halt(culling, t0, t1);
    }
    HWY_NOINLINE bool step(const Culling& culling) {
        const FloatTag d;
        Floats t0[kVectors];
        Floats t1[kVectors];
        RTCORE_EACH_VECTOR
        for (std::size_t i = 0; i < kVectors; ++i) {
            t0[i] = hn::Load(d, halted0_ + i * kLanes);
            t1[i] = hn::Load(d, halted1_ + i * kLanes);
        }
        if (leaves.test({scene_, scene_.nodes[place_.node]}, t0, t1)) return false;
        return next(t0, t1, place_) && halt(culling, t0, t1);
    }

  private:
    /// Where a walk is.
    struct Place {
        std::uint32_t node;
        std::size_t waiting; ///< children on the stack
        Range interval;      ///< as a waiting packet's
    };

    /// Loads the intervals at the root; false when nothing is left to do.
    HWY_INLINE bool enter(Floats (&t0)[kVectors], Floats (&t1)[kVectors], Place& place) {
        const FloatTag d;
        leaves.begin();
        RTCORE_EACH_VECTOR
        for (std::size_t i = 0; i < kVectors; ++i) {
            t0[i] = hn::Load(d, packet_.t0 + i * kLanes);
            t1[i] = hn::Load(d, packet_.t1 + i * kLanes);
        }
        if constexpr (kCull) place.interval = boundsOf(t0, t1);
        if constexpr (kSearch.any) {
            if (leaves.occluder.a != nullptr && leaves.testOccluder(t0, t1)) return false;
        }
        return true;
    }

    /// Goes on to a leaf that has triangles; false where there is none.
    HWY_INLINE bool findLeaf(const Culling& culling, Floats (&t0)[kVectors], Floats (&t1)[kVectors],
                             Place& place) {
        while (true) {
            const KdNode node = scene_.nodes[place.node];
            if (!node.isLeaf()) {
                place.node = descend(node, culling, t0, t1, place.interval, place.waiting);
                continue;
            }
            if constexpr (kSearch.any) cost += kLeafCost + node.count();
            if (node.count() != 0) return true;
            if (!next(t0, t1, place)) return false;
        }
    }

    /// Takes the next child that any ray still enters; false when there is none.
    HWY_INLINE bool next(Floats (&t0)[kVectors], Floats (&t1)[kVectors], Place& place) const {
        const Floats slack = hn::Set(FloatTag(), packet_.slack);
        bool alive = false;
        do {
            if (place.waiting == 0) return false;
            alive = take(stack_[--place.waiting], slack, t0, t1);
        } while (!alive);
        place.node = stack_[place.waiting].node;
        place.interval = stack_[place.waiting].interval;
        return true;
    }

    /// Finds the next leaf, sends for its triangles, and keeps what step() goes on with.
    HWY_INLINE bool halt(const Culling& culling, Floats (&t0)[kVectors], Floats (&t1)[kVectors]) {
        const FloatTag d;
        if (!findLeaf(culling, t0, t1, place_)) return false;
        sendForLeaf(scene_, scene_.nodes[place_.node]);
        if (place_.waiting > 0) hwy::Prefetch(scene_.nodes + stack_[place_.waiting - 1].node);
        RTCORE_EACH_VECTOR
        for (std::size_t i = 0; i < kVectors; ++i) {
            hn::Store(t0[i], d, halted0_ + i * kLanes);
            hn::Store(t1[i], d, halted1_ + i * kLanes);
        }
        return true;
    }

    static constexpr std::uint32_t kStepCost = 1, kLeafCost = 2; ///< in tests of a triangle
    static constexpr float kDown = kPlaneDown;
    static constexpr float kUp = kPlaneUp;

    HWY_INLINE static Range boundsOf(const Floats (&t0)[kVectors], const Floats (&t1)[kVectors]) {
        const FloatTag d;
        const Floats none = hn::Set(d, std::numeric_limits<float>::max());
        Floats lo = none;
        Floats hi = hn::Neg(none);
        RTCORE_EACH_VECTOR
        for (std::size_t i = 0; i < kVectors; ++i) {
            const Mask alive = hn::Le(t0[i], t1[i]);
            lo = hn::Min(lo, hn::IfThenElse(alive, t0[i], none));
            hi = hn::Max(hi, hn::IfThenElse(alive, t1[i], hn::Neg(none)));
        }
        return {hn::GetLane(hn::MinOfLanes(d, lo)), hn::GetLane(hn::MaxOfLanes(d, hi))};
    }

    /// The next node; leaves the intervals of its cell in t0 and t1.
    HWY_INLINE std::uint32_t descend(KdNode node, const Culling& culling, Floats (&t0)[kVectors],
                                     Floats (&t1)[kVectors], Range& interval, std::size_t& waiting) {
        const int axis = node.axis();
        if (!culling.uniform[axis]) return descendMixed(node, t0, t1, interval, waiting);
        const std::uint32_t upperFirst = culling.upperFirst[axis];
        const std::uint32_t near = node.lowerChild() + upperFirst;
        const std::uint32_t far = node.lowerChild() + 1 - upperFirst;
        Range planes{};
        if constexpr (kCull) {
            planes = kShared == Shared::Origin ? culling.planesOfOrigin(axis, node.split)
                                               : culling.planes(axis, node.split);
            if (planes.lo * kDown > interval.hi) return near;
            if (planes.hi * kUp < interval.lo) return far;
        }

        const FloatTag d;
        Floats nearEnd[kVectors];
        Floats farBegin[kVectors];
        Mask entersNear = hn::FirstN(d, 0);
        Mask entersFar = hn::FirstN(d, 0);
        RTCORE_EACH_VECTOR
        for (std::size_t i = 0; i < kVectors; ++i) {
            const Floats t = planeDistance(axis, node.split, culling, i);
            nearEnd[i] = min(hn::Mul(t, hn::Set(d, kUp)), t1[i]);
            farBegin[i] = max(hn::Mul(t, hn::Set(d, kDown)), t0[i]);
            entersNear = hn::Or(entersNear, hn::Le(t0[i], nearEnd[i]));
            entersFar = hn::Or(entersFar, hn::Le(farBegin[i], t1[i]));
        }
        if (hn::AllFalse(d, entersFar)) return near;
        if (hn::AllFalse(d, entersNear)) return far;
        // (What follows is written out for each case: functions for "go near" and "go far" cost 2 %.)
        if (isEmptyLeaf(far)) {
            RTCORE_EACH_VECTOR
            for (std::size_t i = 0; i < kVectors; ++i) t1[i] = nearEnd[i];
            if constexpr (kCull) interval.hi = std::min(interval.hi, planes.hi * kUp);
            return near;
        }
        if (isEmptyLeaf(near)) {
            RTCORE_EACH_VECTOR
            for (std::size_t i = 0; i < kVectors; ++i) t0[i] = farBegin[i];
            if constexpr (kCull) interval.lo = std::max(interval.lo, planes.lo * kDown);
            return far;
        }
        WaitingPacket<kVectors>& entry = stack_[waiting++];
        if constexpr (kSearch.any) {
            cost += kStepCost;
            if (farFirst) {
                entry.node = near;
                if constexpr (kCull) {
                    sendForLeaf(scene_, scene_.nodes[near]);
                    entry.interval = {interval.lo, std::min(interval.hi, planes.hi * kUp)};
                    interval.lo = std::max(interval.lo, planes.lo * kDown);
                }
                RTCORE_EACH_VECTOR
                for (std::size_t i = 0; i < kVectors; ++i) {
                    hn::Store(t0[i], d, entry.t0 + i * kLanes);
                    hn::Store(nearEnd[i], d, entry.t1 + i * kLanes);
                    t0[i] = farBegin[i];
                }
                return far;
            }
        }
        entry.node = far;
        if constexpr (kCull) {
            sendForLeaf(scene_, scene_.nodes[far]);
            entry.interval = {std::max(interval.lo, planes.lo * kDown), interval.hi};
            interval.hi = std::min(interval.hi, planes.hi * kUp);
        }
        RTCORE_EACH_VECTOR
        for (std::size_t i = 0; i < kVectors; ++i) {
            hn::Store(farBegin[i], d, entry.t0 + i * kLanes);
            hn::Store(t1[i], d, entry.t1 + i * kLanes);
            t1[i] = nearEnd[i];
        }
        return near;
    }

    HWY_INLINE bool isEmptyLeaf(std::uint32_t index) const {
        const KdNode node = scene_.nodes[index];
        return node.isLeaf() && node.count() == 0;
    }

    HWY_INLINE Floats planeDistance(int axis, float split, const Culling& culling, std::size_t i) const {
        const FloatTag d;
        const Floats inverse = hn::Load(d, packet_.inverse[axis] + i * kLanes);
        if constexpr (kShared == Shared::Origin) {
            return hn::Mul(hn::Set(d, split - culling.origin[axis].lo), inverse);
        } else {
            return hn::Mul(hn::Sub(hn::Set(d, split), hn::Load(d, packet_.origin[axis] + i * kLanes)),
                           inverse);
        }
    }

    /// Rays that point both ways along the axis: the lower child first, whichever is nearer.
    HWY_NOINLINE std::uint32_t descendMixed(KdNode node, Floats (&t0)[kVectors], Floats (&t1)[kVectors],
                                            Range& interval, std::size_t& waiting) {
        const FloatTag d;
        const int axis = node.axis();
        Mask entersLower = hn::FirstN(d, 0);
        Mask entersUpper = hn::FirstN(d, 0);
        WaitingPacket<kVectors>& entry = stack_[waiting];
        Floats lower0[kVectors];
        Floats lower1[kVectors];
        RTCORE_EACH_VECTOR
        for (std::size_t i = 0; i < kVectors; ++i) {
            const Floats inverse = hn::Load(d, packet_.inverse[axis] + i * kLanes);
            const Floats origin = hn::Load(d, packet_.origin[axis] + i * kLanes);
            const Floats t = hn::Mul(hn::Sub(hn::Set(d, node.split), origin), inverse);
            const Floats nearEnd = min(hn::Mul(t, hn::Set(d, kUp)), t1[i]);
            const Floats farBegin = max(hn::Mul(t, hn::Set(d, kDown)), t0[i]);
            const Mask downwards = hn::Lt(inverse, hn::Zero(d));
            lower0[i] = hn::IfThenElse(downwards, farBegin, t0[i]);
            lower1[i] = hn::IfThenElse(downwards, t1[i], nearEnd);
            const Floats upper0 = hn::IfThenElse(downwards, t0[i], farBegin);
            const Floats upper1 = hn::IfThenElse(downwards, nearEnd, t1[i]);
            hn::Store(upper0, d, entry.t0 + i * kLanes);
            hn::Store(upper1, d, entry.t1 + i * kLanes);
            entersLower = hn::Or(entersLower, hn::Le(lower0[i], lower1[i]));
            entersUpper = hn::Or(entersUpper, hn::Le(upper0, upper1));
        }
        if (hn::AllFalse(d, entersUpper)) return node.lowerChild();
        if (hn::AllFalse(d, entersLower)) return node.lowerChild() + 1;
        entry.node = node.lowerChild() + 1;
        entry.interval = interval;
        ++waiting;
        RTCORE_EACH_VECTOR
        for (std::size_t i = 0; i < kVectors; ++i) {
            t0[i] = lower0[i];
            t1[i] = lower1[i];
        }
        return node.lowerChild();
    }

    /// Takes over the intervals that waited, cut at what was hit since; false when no ray is left.
    HWY_INLINE bool take(const WaitingPacket<kVectors>& entry, Floats slack, Floats (&t0)[kVectors],
                         Floats (&t1)[kVectors]) const {
        const FloatTag d;
        Mask alive = hn::FirstN(d, 0);
        RTCORE_EACH_VECTOR
        for (std::size_t i = 0; i < kVectors; ++i) {
            const Floats best = hn::Load(d, packet_.best + i * kLanes);
            t0[i] = hn::Load(d, entry.t0 + i * kLanes);
            t1[i] = hn::Min(hn::Load(d, entry.t1 + i * kLanes), endOf(best, slack));
            alive = hn::Or(alive, hn::Le(t0[i], t1[i]));
        }
        return !hn::AllFalse(d, alive);
    }

    /// Where a ray's search ends. For any hit that is -1 for those that are done.
    HWY_INLINE static Floats endOf(Floats best, Floats slack) {
        if constexpr (!kSearch.any) return hn::Add(best, slack);
        return hn::IfThenElse(hn::Lt(best, hn::Zero(FloatTag())), best, hn::Add(best, slack));
    }

  public:
    /// For any hit: of two children the one further from the rays' origins is visited first.
    bool farFirst = false;
    std::uint32_t cost = 0; ///< for any hit: about what run() took, is added to
    PacketLeaves<kVectors, kShared, kSearch> leaves;

  private:
    const KernelScene& scene_;
    Packet<kVectors>& packet_;
    Place place_{}; ///< between steps
    alignas(64) float halted0_[Packet<kVectors>::kSize], halted1_[Packet<kVectors>::kSize];
    WaitingPacket<kVectors> stack_[kMaxKdDepth];
};

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
