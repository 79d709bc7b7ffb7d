// A packet - a few vectors of rays - and the triangles of the leaves that it meets. Included once for each
// target.
#if defined(RTCORE_KERNELS_PACKET_LEAVES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_KERNELS_PACKET_LEAVES_INL_H_
#undef RTCORE_KERNELS_PACKET_LEAVES_INL_H_
#else
#define RTCORE_KERNELS_PACKET_LEAVES_INL_H_
#endif

#include "rtcore/kernels/beam-inl.h"
#include "rtcore/kernels/narrow_leaf-inl.h"
#include "rtcore/kernels/triangle_block-inl.h"

#include <bit>

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
    float slack; ///< the largest of all rays'
    float tie;   ///< as in Found

    HWY_INLINE void setSlack(float largest) {
        slack = largest;
        tie = largest * kTieFraction;
    }

    /// On ray `i`.
    HWY_INLINE Vec3 at(std::size_t i, float t) const {
        return {origin[0][i] + direction[0][i] * t, origin[1][i] + direction[1][i] * t,
                origin[2][i] + direction[2][i] * t};
    }
};

/// The leaves that a packet meets. `kShared`: what its rays have in common.
template <std::size_t kVectors, Shared kShared, Search kSearch>
class PacketLeaves {
  public:
    PacketLeaves(const KernelScene& scene, Packet<kVectors>& packet) : scene_(scene), packet_(packet) {}

    /// Needed before a walk unless kShared is Nothing: all rays have the dominant axis `kz`.
    HWY_INLINE void setAxis(int kz) { along_ = alongAxis(kz); }
    /// Needed as well: a point that all rays pass, or as near to them as there is one. Their beams are seen
    /// from there.
    HWY_INLINE void setPoint(Vec3 point) { point_ = point; }

    /// Before each walk: the packet has other rays.
    HWY_INLINE void begin() { leavesReady_ = beamsReady_ = false; }

    /// Tests the triangles of a leaf; true when the walk can end.
    HWY_INLINE bool test(const Leaf& leaf, const Floats (&t0)[kVectors], Floats (&t1)[kVectors]) {
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

    /// For any hit: the last triangle that stopped a ray, if it is not narrow. It is tested first: neighbours
    /// are often stopped by the same.
    Corners occluder;

  private:
    static constexpr std::uint32_t kWorthCulling = 4; ///< triangles of a leaf
    static constexpr std::size_t kTestCost = 10, kBlockCost = 25, kRayCost = 13;

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
        for (std::uint32_t first = 0; first < leaf.common; first += SeenTriangles::kMax) {
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
        for (std::uint32_t first = leaf.common; first < leaf.count; first += SeenTriangles::kMax) {
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
                        hn::Set(d, packet_.tie)};
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

    /// Tests the leaf's references from `first` to before `last`: narrow triangles or common ones.
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
        const AlongAxis along = kShared == Shared::Nothing ? alongAxis(axis_[i]) : along_;
        ray.kx = along.kx;
        ray.ky = along.ky;
        ray.kz = along.kz;
        ray.x = sheared_[0][i];
        ray.y = sheared_[1][i];
        ray.z = sheared_[2][i];
        ray.sx = sheared_[3][i];
        ray.sy = sheared_[4][i];
        ray.minusSz = sheared_[5][i];
        FoundByRay found{packet_.best[i], kSearch.any ? kNone : packet_.triangle[i], 0, 0, 0, packet_.tie};
        bool hit = false;
        if constexpr (kNarrow) {
            hit = block.testNarrow<kSearch>(ray, packet_.tMin[i], found);
        } else {
            hit = block.test<kSearch>(ray, packet_.tMin[i], found);
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

    HWY_INLINE bool allDone() const {
        const FloatTag d;
        Mask open = hn::FirstN(d, 0);
        RTCORE_EACH_VECTOR
        for (std::size_t i = 0; i < kVectors; ++i) {
            open = hn::Or(open, hn::Ge(hn::Load(d, packet_.best + i * kLanes), hn::Zero(d)));
        }
        return hn::AllFalse(d, open);
    }

    const KernelScene& scene_;
    Packet<kVectors>& packet_;
    AlongAxis along_{0, 0, 0};
    Vec3 point_;
    Beam beams_[kVectors];
    bool leavesReady_ = false, beamsReady_ = false;
    alignas(64) float sheared_[6][Packet<kVectors>::kSize];
    alignas(64) std::int32_t axis_[Packet<kVectors>::kSize];
};

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
