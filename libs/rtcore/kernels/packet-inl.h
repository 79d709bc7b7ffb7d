// A packet: a few vectors of rays that walk the tree together, each lane with its own interval of the node's
// cell. Lanes enter exactly the nodes that the single ray enters (single_ray.cpp), or more. Included once for
// each target.
#if defined(RTCORE_KERNELS_PACKET_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_KERNELS_PACKET_INL_H_
#undef RTCORE_KERNELS_PACKET_INL_H_
#else
#define RTCORE_KERNELS_PACKET_INL_H_
#endif

#include "rtcore/kernels/beam-inl.h"
#include "rtcore/kernels/narrow_leaf-inl.h"
#include "rtcore/kernels/rounding.h"
#include "rtcore/kernels/triangle_block-inl.h"

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

// With registers enough for all vectors, loops over them are unrolled, so that the intervals stay there.
#undef RTCORE_EACH_VECTOR
#if HWY_TARGET == HWY_AVX3
#define RTCORE_EACH_VECTOR _Pragma("GCC unroll 4")
#else
#define RTCORE_EACH_VECTOR
#endif

/// The rays of a packet and what they have found, one array for each component.
template <std::size_t kVectors>
struct Packet {
    static constexpr std::size_t kSize = kVectors * kLanes;
    using Array = float[kSize + kLanes]; // room for a vector that is stored past the last ray

    alignas(64) Array origin[3], direction[3], inverse[3];
    alignas(64) Array t0, t1; ///< of the cell where the walk begins; t0 > t1: no ray
    alignas(64) Array tMin;
    alignas(64) Array best; ///< distance of the closest hit; for any hit tMax, or -1 once hit
    alignas(64) std::int32_t triangle[kSize];
    alignas(64) Array v, w, det;
    const std::uint32_t* startTriangle; ///< as RaySpan's; null: none starts on a triangle
    float slack;                        ///< the largest of all rays'

    /// On ray `i`.
    HWY_INLINE Vec3 at(std::size_t i, float t) const {
        return {origin[0][i] + direction[0][i] * t, origin[1][i] + direction[1][i] * t,
                origin[2][i] + direction[2][i] * t};
    }
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
    PacketWalk(const KernelScene& scene, Packet<kVectors>& packet) : scene_(scene), packet_(packet) {}

    /// Needed before run() unless kShared is Nothing: all rays have the dominant axis `kz`.
    HWY_INLINE void setAxis(int kz) { along_ = alongAxis(kz); }
    /// Needed as well: a point that all rays pass, or as near to them as there is one. Their beams are seen
    /// from there.
    HWY_INLINE void setPoint(Vec3 point) { point_ = point; }

    /// Visits all leaves below `root` that any ray meets.
    HWY_NOINLINE void run(std::uint32_t root, const Culling& culling) {
        Floats t0[kVectors];
        Floats t1[kVectors];
        Place place{root, 0, {}};
        if (!enter(t0, t1, place)) return;
        while (findLeaf(culling, t0, t1, place)) {
            if (testLeaf({scene_, scene_.nodes[place.node]}, t0, t1)) return;
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
        if (testLeaf({scene_, scene_.nodes[place_.node]}, t0, t1)) return false;
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
        leavesReady_ = beamsReady_ = false;
        RTCORE_EACH_VECTOR
        for (std::size_t i = 0; i < kVectors; ++i) {
            t0[i] = hn::Load(d, packet_.t0 + i * kLanes);
            t1[i] = hn::Load(d, packet_.t1 + i * kLanes);
        }
        if constexpr (kCull) place.interval = boundsOf(t0, t1);
        if constexpr (kSearch.any) {
            if (occluder.a != nullptr && testOccluder(t0, t1)) return false;
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
    static constexpr std::uint32_t kWorthCulling = 4;            ///< triangles of a leaf
    static constexpr std::size_t kTestCost = 10, kBlockCost = 25, kRayCost = 13;
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

    HWY_NOINLINE void prepareLeaves() {
        const FloatTag d;
        leavesReady_ = true;
        RTCORE_EACH_VECTOR
        for (std::size_t i = 0; i < kVectors; ++i) {
            const std::size_t at = i * kLanes;
            const ShearedRays rays = shearRays(at);
            hn::Store(rays.x, d, sheared_[0] + at);
            hn::Store(rays.y, d, sheared_[1] + at);
            hn::Store(rays.z, d, sheared_[2] + at);
            hn::Store(rays.sx, d, sheared_[3] + at);
            hn::Store(rays.sy, d, sheared_[4] + at);
            hn::Store(rays.minusSz, d, sheared_[5] + at);
            if constexpr (kShared == Shared::Nothing) {
                const IntTag di;
                const auto axis = [&](std::int32_t x) HWY_ATTR { return hn::BitCast(d, hn::Set(di, x)); };
                const Floats kz = axisOrder(at).choose(axis(0), axis(1), axis(2));
                hn::Store(hn::BitCast(di, kz), di, axis_ + at);
            }
        }
    }

    HWY_INLINE ShearedRays shearRays(std::size_t at) const {
        const FloatTag d;
        const auto load = [&](const auto& of, int axis) HWY_ATTR { return hn::Load(d, of[axis] + at); };
        if constexpr (kShared == Shared::Nothing) {
            return shear(axisOrder(at), load(packet_.origin, 0), load(packet_.origin, 1),
                         load(packet_.origin, 2), load(packet_.direction, 0), load(packet_.direction, 1),
                         load(packet_.direction, 2));
        }
        const Floats along = load(packet_.direction, along_.kz);
        return {load(packet_.origin, along_.kx),
                load(packet_.origin, along_.ky),
                load(packet_.origin, along_.kz),
                hn::Div(load(packet_.direction, along_.kx), along),
                hn::Div(load(packet_.direction, along_.ky), along),
                hn::Neg(load(packet_.inverse, along_.kz))};
    }

    HWY_NOINLINE void prepareBeams() {
        beamsReady_ = true;
        for (std::size_t i = 0; i < kVectors; ++i) beams_[i] = beamOf(shearedRays(i * kLanes));
    }

    HWY_INLINE Beam beamOf(const ShearedRays& rays) const {
        constexpr float kWider = Beam::kWider;
        const FloatTag d;
        const Floats level = hn::Sub(hn::Set(d, point_[along_.kz]), rays.z);
        Beam beam;
        for (const int side : {0, 1}) {
            const Floats shear = side == 0 ? rays.sx : rays.sy;
            beam.shear[side][0] = hn::GetLane(hn::MinOfLanes(d, shear)) - kWider;
            beam.shear[side][1] = hn::GetLane(hn::MaxOfLanes(d, shear)) + kWider;
            const Floats across =
                hn::Sub(hn::Set(d, point_[side == 0 ? along_.kx : along_.ky]), side == 0 ? rays.x : rays.y);
            const Floats place = hn::NegMulAdd(shear, level, across);
            const Floats wider = hn::Mul(hn::Add(hn::Abs(across), hn::Abs(level)), hn::Set(d, kWider));
            beam.place[side][0] = hn::GetLane(hn::MinOfLanes(d, hn::Sub(place, wider)));
            beam.place[side][1] = hn::GetLane(hn::MaxOfLanes(d, hn::Add(place, wider)));
        }
        return beam;
    }

    HWY_INLINE ShearedRays shearedRays(std::size_t at) const {
        const FloatTag d;
        return {hn::Load(d, sheared_[0] + at), hn::Load(d, sheared_[1] + at), hn::Load(d, sheared_[2] + at),
                hn::Load(d, sheared_[3] + at), hn::Load(d, sheared_[4] + at), hn::Load(d, sheared_[5] + at)};
    }

    /// Calls `work` with what brings corners to the vector at `at`.
    template <typename Work>
    HWY_INLINE void withAlong(std::size_t at, const Work& work) const {
        if constexpr (kShared == Shared::Nothing) {
            const AxisOrder order = axisOrder(at);
            work(AlongEach{order});
        } else {
            work(along_);
        }
    }

    /// Tests the triangles of a leaf; true when the walk can end.
    HWY_INLINE bool testLeaf(const Leaf& leaf, const Floats (&t0)[kVectors], Floats (&t1)[kVectors]) {
        const FloatTag d;
        if (!leavesReady_) prepareLeaves();
        std::size_t vectors = 0;
        std::size_t rays = 0;
        RTCORE_EACH_VECTOR
        for (std::size_t k = 0; k < kVectors; ++k) {
            const std::size_t inCell = hn::CountTrue(d, hn::Le(t0[k], t1[k]));
            rays += inCell;
            vectors += inCell > 0 ? 1 : 0;
        }
        if (testCommonOnes(leaf, rays, vectors, t0, t1)) return true;
        if (HWY_LIKELY(leaf.common == leaf.count)) return false;
        if (rayByRayPays(rays, vectors, leaf.count - leaf.common))
            return testRayByRay<true>(leaf, leaf.common, leaf.count, t0, t1);
        return testNarrow(leaf, t0, t1);
    }

    /// Tests the common triangles of a leaf that so many rays and vectors meet.
    HWY_INLINE bool testCommonOnes(const Leaf& leaf, std::size_t rays, std::size_t vectors,
                                   const Floats (&t0)[kVectors], Floats (&t1)[kVectors]) {
        if (rayByRayPays(rays, vectors, leaf.common))
            return testRayByRay<false>(leaf, 0, leaf.common, t0, t1);
        if (kShared != Shared::Nothing && leaf.common >= kWorthCulling) return testCulled(leaf, t0, t1);
        const auto remember = [&](const Corners& corners) HWY_ATTR { occluder = corners; };
        const auto test = [&](std::size_t at, Mask inCell, Found& found) HWY_ATTR {
            const Floats tMin = hn::Load(FloatTag(), packet_.tMin + at);
            const ShearedRays sheared = shearedRays(at);
            withAlong(at, [&](const auto& along) HWY_ATTR {
                testTriangles<kSearch>(scene_, leaf, along, sheared, tMin, inCell, found, remember);
            });
        };
        return leaf.common > 0 && testVectors(test, t0, t1);
    }

    /// Tests the common triangles of a leaf against those vectors whose beams may meet them.
    HWY_NOINLINE bool testCulled(const Leaf& leaf, const Floats (&t0)[kVectors], Floats (&t1)[kVectors]) {
        const FloatTag d;
        const auto remember = [&](const Corners& corners) HWY_ATTR { occluder = corners; };
        if (!beamsReady_) prepareBeams();
        for (std::uint32_t first = 0; first < leaf.common; first += SeenTriangles::kMost) {
            const SeenTriangles triangles(scene_, leaf, first, leaf.common, point_);
            const auto test = [&](std::size_t at, Mask inCell, Found& found) HWY_ATTR {
                std::uint32_t which = candidatesOf(triangles, at);
                if (which == 0) return;
                const Floats tMin = hn::Load(d, packet_.tMin + at);
                const ShearedRays rays = shearedRays(at);
                for (; which != 0; which &= which - 1) {
                    const auto i = first + static_cast<std::uint32_t>(std::countr_zero(which));
                    testCommon<kSearch>(scene_, leaf, i, along_, rays, tMin, inCell, found, remember);
                }
            };
            if (testVectors(test, t0, t1)) return true;
        }
        return false;
    }

    /// Which triangles rays of the vector at `at` may meet, a bit for each.
    HWY_INLINE std::uint32_t candidatesOf(const SeenTriangles& triangles, std::size_t at) const {
        std::uint32_t candidates[1];
        findCandidates<kShared == Shared::Origin>(triangles, along_, &beams_[at / kLanes], candidates);
        return candidates[0];
    }

    /// Tests the narrow triangles of a leaf.
    HWY_NOINLINE bool testNarrow(const Leaf& leaf, const Floats (&t0)[kVectors], Floats (&t1)[kVectors]) {
        const FloatTag d;
        if constexpr (kShared == Shared::Nothing) {
            const auto test = [&](std::size_t at, Mask inCell, Found& found) HWY_ATTR {
                const AxisOrder order = axisOrder(at);
                testNarrowTriangles<kSearch>(scene_, leaf, AlongEach{order}, shearedRays(at),
                                             hn::Load(d, packet_.tMin + at), inCell, found);
            };
            return testVectors(test, t0, t1);
        }
        if (!beamsReady_) prepareBeams();
        for (std::uint32_t first = leaf.common; first < leaf.count; first += SeenTriangles::kMost) {
            const SeenTriangles triangles(scene_, leaf, first, leaf.count, point_);
            const auto test = [&](std::size_t at, Mask inCell, Found& found) HWY_ATTR {
                const std::uint32_t which = candidatesOf(triangles, at);
                if (which == 0) return;
                testNarrowTriangles<kSearch>(scene_, leaf, first, which, along_, shearedRays(at),
                                             hn::Load(d, packet_.tMin + at), inCell, found);
            };
            if (testVectors(test, t0, t1)) return true;
        }
        return false;
    }

    /// Tests the triangle that stopped a ray before.
    HWY_NOINLINE bool testOccluder(const Floats (&t0)[kVectors], Floats (&t1)[kVectors]) {
        const FloatTag d;
        if (!leavesReady_) prepareLeaves();
        const auto test = [&](std::size_t at, Mask inCell, Found& found) HWY_ATTR {
            const Floats tMin = hn::Load(d, packet_.tMin + at);
            const ShearedRays rays = shearedRays(at);
            withAlong(at, [&](const auto& along) HWY_ATTR {
                testTriangle<kSearch>(scene_, occluder, along, rays, tMin, inCell, found);
            });
        };
        return testVectors(test, t0, t1);
    }

    /// Runs `test` for each vector that has rays in the cell, and keeps what they find.
    template <typename Test>
    HWY_INLINE bool testVectors(const Test& test, const Floats (&t0)[kVectors], Floats (&t1)[kVectors]) {
        const FloatTag d;
        const IntTag di;
        bool any = false;
        RTCORE_EACH_VECTOR
        for (std::size_t k = 0; k < kVectors; ++k) {
            const Mask inCell = hn::Le(t0[k], t1[k]);
            if (hn::AllFalse(d, inCell)) continue;
            const std::size_t at = k * kLanes;
            Found found{hn::Load(d, packet_.best + at),
                        hn::Zero(di),
                        hn::Zero(d),
                        hn::Zero(d),
                        hn::Zero(d),
                        hn::FirstN(d, 0),
                        hn::FirstN(d, 0),
                        startsAt(packet_.startTriangle, at)};
            if constexpr (!kSearch.any) found.triangle = hn::Load(di, packet_.triangle + at);
            test(at, inCell, found);
            if constexpr (kSearch.any) notePassed(found, at);
            if (hn::AllFalse(d, found.changed)) continue;
            any = true;
            hn::Store(found.best, d, packet_.best + at);
            if constexpr (kSearch.any) {
                t1[k] = hn::IfThenElse(found.changed, hn::Set(d, -1.0F), t1[k]);
            } else {
                hn::Store(found.triangle, di, packet_.triangle + at);
                hn::BlendedStore(found.v, found.changed, d, packet_.v + at);
                hn::BlendedStore(found.w, found.changed, d, packet_.w + at);
                hn::BlendedStore(found.det, found.changed, d, packet_.det + at);
            }
        }
        return kSearch.any && any && allDone();
    }

    /// Any other triangle than kNone: the ray passes through one that lets light through.
    HWY_INLINE void notePassed(const Found& found, std::size_t at) {
        const IntTag di;
        if (HWY_LIKELY(hn::AllFalse(FloatTag(), found.passed))) return;
        hn::BlendedStore(hn::Zero(di), hn::RebindMask(di, found.passed), di, packet_.triangle + at);
    }

    HWY_INLINE AxisOrder axisOrder(std::size_t at) const {
        const FloatTag d;
        return AxisOrder(hn::Load(d, packet_.direction[0] + at), hn::Load(d, packet_.direction[1] + at),
                         hn::Load(d, packet_.direction[2] + at));
    }

    /// Whether a leaf of `count` triangles takes less time when each of the rays is tested against vectors of
    /// triangles, in units of one test (measured).
    HWY_INLINE bool rayByRayPays(std::size_t rays, std::size_t vectors, std::size_t count) const {
        const std::size_t blocks = (count + kLanes - 1) / kLanes;
        const std::size_t blockCost = scene_.records == nullptr ? kBlockCost : 0;
        return blocks * (blockCost + kRayCost * rays) < kTestCost * count * vectors;
    }

    /// Of the leaf's references those from `first` to before `last`: narrow triangles or common ones.
    template <bool kNarrow>
    HWY_NOINLINE bool testRayByRay(const Leaf& leaf, std::uint32_t first, std::uint32_t last,
                                   const Floats (&t0)[kVectors], Floats (&t1)[kVectors]) {
        const FloatTag d;
        Mask inCell[kVectors];
        for (std::size_t k = 0; k < kVectors; ++k) inCell[k] = hn::Le(t0[k], t1[k]);
        bool hit = false;
        TriangleBlock block(scene_, leaf);
        for (std::uint32_t i = first; i < last; i += static_cast<std::uint32_t>(kLanes)) {
            block.load(i, last);
            RTCORE_EACH_VECTOR
            for (std::size_t k = 0; k < kVectors; ++k) {
                forEachLane(inCell[k], [&](std::size_t lane)
                                           HWY_ATTR { hit |= testRay<kNarrow>(block, k * kLanes + lane); });
            }
        }
        if (!kSearch.any || !hit) return false;
        RTCORE_EACH_VECTOR
        for (std::size_t k = 0; k < kVectors; ++k) {
            const Floats best = hn::Load(d, packet_.best + k * kLanes);
            t1[k] = hn::IfThenElse(hn::Lt(best, hn::Zero(d)), best, t1[k]);
        }
        return allDone();
    }

    template <bool kNarrow>
    HWY_INLINE bool testRay(const TriangleBlock& block, std::size_t i) {
        ShearedRay ray{};
        const int kz = kShared == Shared::Nothing ? axis_[i] : along_.kz;
        ray.kx = (kz + 1) % 3;
        ray.ky = (kz + 2) % 3;
        ray.kz = kz;
        ray.x = sheared_[0][i];
        ray.y = sheared_[1][i];
        ray.z = sheared_[2][i];
        ray.sx = sheared_[3][i];
        ray.sy = sheared_[4][i];
        ray.minusSz = sheared_[5][i];
        FoundByRay found{packet_.best[i], kSearch.any ? kNone : packet_.triangle[i], 0, 0, 0};
        bool hit = false;
        if constexpr (kNarrow) {
            hit = block.testNarrow<kSearch>(ray, packet_.tMin[i], startOf(i), found);
        } else {
            hit = block.test<kSearch>(ray, packet_.tMin[i], startOf(i), found);
        }
        if (kSearch.any && HWY_UNLIKELY(found.passed)) packet_.triangle[i] = 0;
        if (!hit) return false;
        packet_.best[i] = found.best;
        if constexpr (kSearch.any) {
            if (!kNarrow) occluder = block.corners(static_cast<std::uint32_t>(found.triangle));
        } else {
            packet_.triangle[i] = found.triangle;
            packet_.v[i] = found.v;
            packet_.w[i] = found.w;
            packet_.det[i] = found.det;
        }
        return true;
    }

    HWY_INLINE std::uint32_t startOf(std::size_t i) const {
        return packet_.startTriangle == nullptr ? kNoTriangle : packet_.startTriangle[i];
    }

    HWY_INLINE bool allDone() const {
        const FloatTag d;
        Mask open = hn::FirstN(d, 0);
        RTCORE_EACH_VECTOR
        for (std::size_t i = 0; i < kVectors; ++i) {
            open = hn::Or(open, hn::Ge(hn::Load(d, packet_.best + i * kLanes), hn::Zero(d)));
        }
        return hn::AllFalse(d, open);
    }

  public:
    /// For any hit: the last triangle that stopped a ray, if it is not narrow. It is tested first: neighbours
    /// are often stopped by the same.
    Corners occluder;
    /// For any hit: of two children the one further from the rays' origins is visited first.
    bool farFirst = false;
    std::uint32_t cost = 0; ///< for any hit: about what run() took, is added to

  private:
    const KernelScene& scene_;
    Packet<kVectors>& packet_;
    AlongAxis along_{0, 0, 0};
    Vec3 point_;
    Beam beams_[kVectors];
    bool leavesReady_ = false, beamsReady_ = false;
    alignas(64) float sheared_[6][Packet<kVectors>::kSize];
    alignas(64) std::int32_t axis_[Packet<kVectors>::kSize];
    Place place_{}; ///< between steps
    alignas(64) float halted0_[Packet<kVectors>::kSize], halted1_[Packet<kVectors>::kSize];
    WaitingPacket<kVectors> stack_[kMaxKdDepth];
};

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
