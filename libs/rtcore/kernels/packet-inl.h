// A packet: a few vectors of rays that walk the tree together, each lane with its own interval of the node's
// cell. Lanes enter exactly the nodes that the single ray enters (single_ray.cpp), or more. Included once for
// each target.
#if defined(RTCORE_KERNELS_PACKET_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_KERNELS_PACKET_INL_H_
#undef RTCORE_KERNELS_PACKET_INL_H_
#else
#define RTCORE_KERNELS_PACKET_INL_H_
#endif

#include "rtcore/kernels/leaf_test-inl.h"
#include "rtcore/kernels/rounding.h"

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// The rays of a packet and what they have found, one array for each component.
template <std::size_t kVectors>
struct Packet {
    static constexpr std::size_t kSize = kVectors * kLanes;
    using Array = float[kSize];

    alignas(64) Array origin[3], direction[3], inverse[3];
    alignas(64) Array t0, t1; ///< of the cell where the walk begins; t0 > t1: no ray
    alignas(64) Array tMin;
    alignas(64) Array best; ///< distance of the closest hit; for any hit tMax, or -1 once hit
    alignas(64) std::int32_t triangle[kSize];
    alignas(64) Array v, w, det;
    float slack; ///< the largest of all rays'
};

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

constexpr std::uint32_t kNoReference = 0xFFFFFFFFU;

/// A child that waits, with the intervals of all rays in its cell.
template <std::size_t kVectors>
struct WaitingPacket {
    alignas(64) float t0[kVectors * kLanes], t1[kVectors * kLanes];
    std::uint32_t node;
    Range interval; ///< no ray's interval reaches beyond it
};

/// `kCull`: worth trying to decide for all rays at once.
template <std::size_t kVectors, Shared kShared, bool kCull, bool kAny>
class PacketWalk {
  public:
    PacketWalk(const KernelScene& scene, Packet<kVectors>& packet) : scene_(scene), packet_(packet) {}

    /// Needed before run() unless kShared is Nothing: all rays have the dominant axis `kz`.
    HWY_INLINE void setAxis(int kz) {
        kz_ = kz;
        kx_ = (kz + 1) % 3;
        ky_ = (kz + 2) % 3;
    }

    /// Visits all leaves below `root` that any ray meets.
    HWY_NOINLINE void run(std::uint32_t root, const Culling& culling) {
        const FloatTag d;
        const Floats slack = hn::Set(d, packet_.slack);
        leavesReady_ = false;
        Floats t0[kVectors];
        Floats t1[kVectors];
        Range interval{};
        for (std::size_t i = 0; i < kVectors; ++i) {
            t0[i] = hn::Load(d, packet_.t0 + i * kLanes);
            t1[i] = hn::Load(d, packet_.t1 + i * kLanes);
        }
        if constexpr (kCull) interval = boundsOf(t0, t1);
        if constexpr (kAny) {
            if (occluder != kNoReference && testReference(occluder, t0, t1) && allDone()) return;
        }
        std::size_t waiting = 0;
        std::uint32_t index = root;
        while (true) {
            const KdNode node = scene_.nodes[index];
            if (!node.isLeaf()) {
                index = descend(node, culling, t0, t1, interval, waiting);
                continue;
            }
            if (node.count() != 0 && testLeaf(node, t0, t1)) return;
            bool alive = false;
            do {
                if (waiting == 0) return;
                alive = take(stack_[--waiting], slack, t0, t1);
            } while (!alive);
            index = stack_[waiting].node;
            interval = stack_[waiting].interval;
        }
    }

  private:
    static constexpr float kDown = kPlaneDown;
    static constexpr float kUp = kPlaneUp;

    HWY_INLINE static Range boundsOf(const Floats (&t0)[kVectors], const Floats (&t1)[kVectors]) {
        const FloatTag d;
        const Floats none = hn::Set(d, std::numeric_limits<float>::max());
        Floats lo = none;
        Floats hi = hn::Neg(none);
        for (std::size_t i = 0; i < kVectors; ++i) {
            const Lanes alive = hn::Le(t0[i], t1[i]);
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
        Lanes entersNear = hn::FirstN(d, 0);
        Lanes entersFar = hn::FirstN(d, 0);
        for (std::size_t i = 0; i < kVectors; ++i) {
            const Floats t = planeDistance(axis, node.split, culling, i);
            nearEnd[i] = smaller(hn::Mul(t, hn::Set(d, kUp)), t1[i]);
            farBegin[i] = larger(hn::Mul(t, hn::Set(d, kDown)), t0[i]);
            entersNear = hn::Or(entersNear, hn::Le(t0[i], nearEnd[i]));
            entersFar = hn::Or(entersFar, hn::Le(farBegin[i], t1[i]));
        }
        if (hn::AllFalse(d, entersFar)) return near;
        if (hn::AllFalse(d, entersNear)) return far;
        WaitingPacket<kVectors>& entry = stack_[waiting++];
        entry.node = far;
        if constexpr (kCull) {
            entry.interval = {std::max(interval.lo, planes.lo * kDown), interval.hi};
            interval.hi = std::min(interval.hi, planes.hi * kUp);
        }
        for (std::size_t i = 0; i < kVectors; ++i) {
            hn::Store(farBegin[i], d, entry.t0 + i * kLanes);
            hn::Store(t1[i], d, entry.t1 + i * kLanes);
            t1[i] = nearEnd[i];
        }
        return near;
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
        Lanes entersLower = hn::FirstN(d, 0);
        Lanes entersUpper = hn::FirstN(d, 0);
        WaitingPacket<kVectors>& entry = stack_[waiting];
        Floats lower0[kVectors];
        Floats lower1[kVectors];
        for (std::size_t i = 0; i < kVectors; ++i) {
            const Floats inverse = hn::Load(d, packet_.inverse[axis] + i * kLanes);
            const Floats origin = hn::Load(d, packet_.origin[axis] + i * kLanes);
            const Floats t = hn::Mul(hn::Sub(hn::Set(d, node.split), origin), inverse);
            const Floats nearEnd = smaller(hn::Mul(t, hn::Set(d, kUp)), t1[i]);
            const Floats farBegin = larger(hn::Mul(t, hn::Set(d, kDown)), t0[i]);
            const Lanes downwards = hn::Lt(inverse, hn::Zero(d));
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
        Lanes alive = hn::FirstN(d, 0);
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
        if constexpr (!kAny) return hn::Add(best, slack);
        return hn::IfThenElse(hn::Lt(best, hn::Zero(FloatTag())), best, hn::Add(best, slack));
    }

    HWY_NOINLINE void prepareLeaves() {
        const FloatTag d;
        leavesReady_ = true;
        for (std::size_t i = 0; i < kVectors; ++i) {
            const std::size_t at = i * kLanes;
            Floats o[3];
            Floats dir[3];
            for (int axis = 0; axis < 3; ++axis) {
                o[axis] = hn::Load(d, packet_.origin[axis] + at);
                dir[axis] = hn::Load(d, packet_.direction[axis] + at);
            }
            const AxisOrder order(dir[0], dir[1], dir[2]);
            const ShearedRays rays = shear(order, o[0], o[1], o[2], dir[0], dir[1], dir[2]);
            hn::Store(rays.x, d, sheared_[0] + at);
            hn::Store(rays.y, d, sheared_[1] + at);
            hn::Store(rays.z, d, sheared_[2] + at);
            hn::Store(rays.sx, d, sheared_[3] + at);
            hn::Store(rays.sy, d, sheared_[4] + at);
            hn::Store(rays.sz, d, sheared_[5] + at);
            if constexpr (kShared == Shared::Nothing) {
                const ByteTag bytes;
                hn::Store(order.x, bytes, order_[0] + at * sizeof(float));
                hn::Store(order.y, bytes, order_[1] + at * sizeof(float));
                hn::Store(order.z, bytes, order_[2] + at * sizeof(float));
            }
        }
    }

    HWY_INLINE ShearedRays shearedRays(std::size_t at) const {
        const FloatTag d;
        return {hn::Load(d, sheared_[0] + at), hn::Load(d, sheared_[1] + at), hn::Load(d, sheared_[2] + at),
                hn::Load(d, sheared_[3] + at), hn::Load(d, sheared_[4] + at), hn::Load(d, sheared_[5] + at)};
    }

    /// The three corners at the rays of vector `at`.
    HWY_INLINE Offset offset(const float* corner, const ShearedRays& rays, std::size_t at) const {
        const FloatTag d;
        if constexpr (kShared == Shared::Origin) {
            return {hn::Set(d, corner[kx_] - packet_.origin[kx_][0]),
                    hn::Set(d, corner[ky_] - packet_.origin[ky_][0]),
                    hn::Set(d, corner[kz_] - packet_.origin[kz_][0])};
        } else if constexpr (kShared == Shared::Axis) {
            return offsetAlong(corner, kx_, ky_, kz_, rays);
        } else {
            const ByteTag bytes;
            const Bytes all = hn::BitCast(bytes, hn::LoadDup128(d, corner));
            const auto place = [&](int i) HWY_ATTR {
                return hn::BitCast(d, hn::TableLookupBytes(
                                          all, hn::Load(bytes, order_[i] + at * sizeof(float))));
            };
            return {hn::Sub(place(0), rays.x), hn::Sub(place(1), rays.y), hn::Sub(place(2), rays.z)};
        }
    }

    /// Tests the triangles of a leaf; true when the walk can end.
    HWY_INLINE bool testLeaf(KdNode leaf, const Floats (&t0)[kVectors], Floats (&t1)[kVectors]) {
        bool hit = false;
        for (std::uint32_t i = 0; i < leaf.count(); ++i) {
            hit |= testReference(leaf.firstReference + i, t0, t1);
        }
        return kAny && hit && allDone();
    }

    /// Tests one triangle; true when any ray hits it. For any hit, those that do take no further part.
    HWY_INLINE bool testReference(std::uint32_t reference, const Floats (&t0)[kVectors],
                                  Floats (&t1)[kVectors]) {
        const FloatTag d;
        if (!leavesReady_) prepareLeaves();
        const Corners corners = cornersOf(scene_, reference);
        Lanes any = hn::FirstN(d, 0);
        for (std::size_t k = 0; k < kVectors; ++k) {
            const std::size_t at = k * kLanes;
            const ShearedRays rays = shearedRays(at);
            const Outcome outcome = edgeTest(offset(corners.a, rays, at), offset(corners.b, rays, at),
                                             offset(corners.c, rays, at), rays);
            const Lanes alive = hn::And(outcome.inside, hn::Le(t0[k], t1[k]));
            if constexpr (kAny) {
                const Lanes hit = keepAny(outcome, alive, at);
                t1[k] = hn::IfThenElse(hit, hn::Set(d, -1.0F), t1[k]);
                any = hn::Or(any, hit);
            } else {
                keepClosest(outcome, alive, corners.triangle, at);
            }
        }
        if (!kAny || hn::AllFalse(d, any)) return false;
        occluder = reference;
        return true;
    }

    HWY_INLINE Lanes keepAny(const Outcome& outcome, Lanes alive, std::size_t at) {
        const FloatTag d;
        const Floats best = hn::Load(d, packet_.best + at);
        const Lanes hit = hn::And(alive, hn::And(hn::Ge(outcome.t, hn::Load(d, packet_.tMin + at)),
                                                 hn::Le(outcome.t, best)));
        hn::Store(hn::IfThenElse(hit, hn::Set(d, -1.0F), best), d, packet_.best + at);
        return hit;
    }

    HWY_INLINE void keepClosest(const Outcome& outcome, Lanes alive, std::int32_t triangle, std::size_t at) {
        const FloatTag d;
        const IntTag di;
        const Floats best = hn::Load(d, packet_.best + at);
        const Ints known = hn::Load(di, packet_.triangle + at);
        const Ints index = hn::Set(di, triangle);
        const Lanes lower = hn::RebindMask(d, hn::Lt(index, known));
        const Lanes closer =
            hn::Or(hn::Lt(outcome.t, best), hn::And(hn::Eq(outcome.t, best), lower));
        const Lanes hit = hn::And(hn::And(alive, closer), hn::Ge(outcome.t, hn::Load(d, packet_.tMin + at)));
        if (hn::AllFalse(d, hit)) return;
        hn::Store(hn::IfThenElse(hit, outcome.t, best), d, packet_.best + at);
        hn::Store(hn::IfThenElse(hn::RebindMask(di, hit), index, known), di, packet_.triangle + at);
        hn::Store(hn::IfThenElse(hit, outcome.v, hn::Load(d, packet_.v + at)), d, packet_.v + at);
        hn::Store(hn::IfThenElse(hit, outcome.w, hn::Load(d, packet_.w + at)), d, packet_.w + at);
        hn::Store(hn::IfThenElse(hit, outcome.det, hn::Load(d, packet_.det + at)), d, packet_.det + at);
    }

    HWY_INLINE bool allDone() const {
        const FloatTag d;
        Lanes open = hn::FirstN(d, 0);
        for (std::size_t i = 0; i < kVectors; ++i) {
            open = hn::Or(open, hn::Ge(hn::Load(d, packet_.best + i * kLanes), hn::Zero(d)));
        }
        return hn::AllFalse(d, open);
    }

  public:
    /// For any hit: the last reference that stopped a ray. It is tested first: neighbours are often stopped by
    /// the same.
    std::uint32_t occluder = kNoReference;

  private:
    const KernelScene& scene_;
    Packet<kVectors>& packet_;
    int kx_ = 0, ky_ = 0, kz_ = 0;
    bool leavesReady_ = false;
    alignas(64) float sheared_[6][Packet<kVectors>::kSize];
    alignas(64) std::uint8_t order_[3][Packet<kVectors>::kSize * sizeof(float)];
    WaitingPacket<kVectors> stack_[kMaxKdDepth];
};

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
