// Narrow triangles of leaves, whose distances are taken in double: precise_hit.h, with the same bits.
// Included once for each target.
#if defined(RTCORE_KERNELS_NARROW_LEAF_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_KERNELS_NARROW_LEAF_INL_H_
#undef RTCORE_KERNELS_NARROW_LEAF_INL_H_
#else
#define RTCORE_KERNELS_NARROW_LEAF_INL_H_
#endif

#include "rtcore/kernels/leaf_test-inl.h"
#include "rtcore/kernels/precise_hit.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

using DoubleTag = hn::ScalableTag<double>;
using Doubles = hn::Vec<DoubleTag>;

/// A vector of rays and one triangle, column by column, and what preciseHit() says of them.
struct PreciseTest {
    static constexpr std::size_t kRay = 6, kColumns = kRay + 9;

    template <typename Along>
    HWY_INLINE PreciseTest(const Corners& corners, const Along& along, const ShearedRays& rays) {
        const FloatTag d;
        const Floats zero = hn::Zero(d);
        const ShearedRays atZero{zero, zero, zero, zero, zero, zero};
        const Floats ray[] = {rays.x, rays.y, rays.z, rays.sx, rays.sy, rays.minusSz};
        for (std::size_t i = 0; i < kRay; ++i) hn::Store(ray[i], d, column[i]);
        const float* const corner[] = {corners.a, corners.b, corners.c};
        for (std::size_t i = 0; i < 3; ++i) {
            const Offset fromRay = along.offset(corner[i], corners.stride, atZero);
            hn::Store(hn::Neg(fromRay.x), d, column[kRay + 3 * i]);
            hn::Store(hn::Neg(fromRay.y), d, column[kRay + 3 * i + 1]);
            hn::Store(hn::Neg(fromRay.z), d, column[kRay + 3 * i + 2]);
        }
    }

    /// The lanes `which`, at least; where the ray passes beside the triangle, `inside` is 0 and the rest not
    /// yet right.
    template <Search kSearch>
    HWY_INLINE void run(Mask which) {
        const DoubleTag dd;
        const hn::Rebind<float, DoubleTag> half;
        const std::uint32_t wanted = bitsOf(which);
        for (std::size_t i = 0; i < kLanes; i += hn::Lanes(dd)) {
            if ((wanted >> i & ((1U << hn::Lanes(dd)) - 1)) == 0) continue;
            const auto get = [&](std::size_t c)
                                 HWY_ATTR { return hn::PromoteTo(dd, hn::Load(half, column[c] + i)); };
            Doubles x[3];
            Doubles y[3];
            Doubles z[3];
            for (std::size_t c = 0; c < 3; ++c) {
                const std::size_t first = kRay + 3 * c;
                z[c] = hn::Sub(get(2), get(first + 2));
                x[c] = hn::Sub(hn::Sub(get(0), get(first)), hn::Mul(get(3), z[c]));
                y[c] = hn::Sub(hn::Sub(get(1), get(first + 1)), hn::Mul(get(4), z[c]));
            }
            const auto edge = [&](int from, int to) HWY_ATTR {
                return hn::Sub(hn::Mul(x[from], y[to]), hn::Mul(y[from], x[to]));
            };
            const Doubles u = edge(2, 1);
            const Doubles v = edge(0, 2);
            const Doubles w = edge(1, 0);
            const Doubles det = hn::Add(hn::Add(u, v), w);
            const Doubles zero = hn::Zero(dd);
            const auto front = hn::Ge(hn::Min(hn::Min(u, v), w), zero);
            const auto back = hn::Le(hn::Max(hn::Max(u, v), w), zero);
            const auto meets = hn::And(hn::Or(front, back), hn::Ne(det, zero));
            const Doubles sum = hn::Add(hn::Add(hn::Mul(u, z[0]), hn::Mul(v, z[1])), hn::Mul(w, z[2]));
            const auto put = [&](Doubles value, float* to)
                                 HWY_ATTR { hn::Store(hn::DemoteTo(half, value), half, to + i); };
            put(hn::IfThenElseZero(meets, hn::Set(dd, 1.0)), inside);
            put(hn::Mul(hn::Div(sum, det), get(5)), t);
            if constexpr (kSearch.any && !kSearch.filtered) continue;
            put(hn::Div(v, det), weight1);
            put(hn::Div(w, det), weight2);
        }
    }

    alignas(64) float column[kColumns][kLanes]; ///< x, y, z, sx, sy, minusSz; x, y, z of each corner
    alignas(64) float inside[kLanes], t[kLanes], weight1[kLanes], weight2[kLanes];
};

/// isDoubtful() of those inside.
HWY_INLINE Mask areDoubtful(const Outcome& outcome, float noise) {
    return hn::AndNot(hn::Ge(hn::Abs(outcome.sum), hn::Set(FloatTag(), noise)), outcome.inside);
}

/// Puts preciseHit() into what the test of a narrow triangle says of the lanes `which`.
template <Search kSearch, typename Along>
HWY_INLINE void makePrecise(const Corners& corners, const Along& along, const ShearedRays& rays, Mask which,
                            Outcome& outcome) {
    const FloatTag d;
    PreciseTest test(corners, along, rays);
    test.template run<kSearch>(which);
    const Mask beside = hn::AndNot(hn::Ne(hn::Load(d, test.inside), hn::Zero(d)), which);
    if (HWY_UNLIKELY(!hn::AllFalse(d, beside))) {
        forEachLane(beside, [&](std::size_t i) {
            const auto of = [&](std::size_t column) { return test.column[column][i]; };
            const auto corner = [&](std::size_t c) {
                const std::size_t first = PreciseTest::kRay + 3 * c;
                return Vec3{of(first), of(first + 1), of(first + 2)};
            };
            // In the order of the dominant axis already.
            const ShearedRay ray{0, 1, 2, of(0), of(1), of(2), of(3), of(4), of(5)};
            const PreciseHit hit = preciseHit(ray, corner(0), corner(1), corner(2));
            test.t[i] = hit.t;
            test.weight1[i] = hit.v;
            test.weight2[i] = hit.w;
        });
    }
    const Floats t = hn::Load(d, test.t);
    const Mask tooFar = hn::Not(hn::Le(hn::Abs(t), hn::Set(d, std::numeric_limits<float>::max())));
    outcome.inside = hn::AndNot(hn::And(which, tooFar), outcome.inside);
    outcome.t = hn::IfThenElse(which, t, outcome.t);
    if constexpr (kSearch.any && !kSearch.filtered) return;
    outcome.v = hn::IfThenElse(which, hn::Load(d, test.weight1), outcome.v);
    outcome.w = hn::IfThenElse(which, hn::Load(d, test.weight2), outcome.w);
    outcome.det = hn::IfThenElse(which, hn::Set(d, 1.0F), outcome.det);
}

/// Tests a narrow triangle.
template <Search kSearch, typename Along>
HWY_INLINE void testNarrowTriangle(const KernelScene& scene, const Corners& corners, const Along& along,
                                   const ShearedRays& rays, Floats tMin, Mask inCell, Found& found) {
    if (isHidden<kSearch>(scene, corners.triangle)) return;
    Outcome outcome = edgeTest(corners, along, rays);
    outcome.inside = hn::And(outcome.inside, inCell);
    if (hn::AllFalse(FloatTag(), outcome.inside)) return;
    const float noise = scene.noise[static_cast<std::size_t>(corners.triangle)];
    const Mask doubtful = areDoubtful(outcome, noise);
    if (!hn::AllFalse(FloatTag(), doubtful)) makePrecise<kSearch>(corners, along, rays, doubtful, outcome);
    filter<kSearch>(scene, corners.triangle, tMin, inCell, found, outcome);
    if (isPassed<kSearch>(scene, corners)) {
        keepPassed(outcome, tMin, inCell, found);
        return;
    }
    keepHits<kSearch>(outcome, corners.triangle, tMin, inCell, found);
}

/// Tests the narrow triangles of a leaf.
template <Search kSearch, typename Along>
HWY_NOINLINE void testNarrowTriangles(const KernelScene& scene, const Leaf& leaf, const Along& along,
                                      const ShearedRays& rays, Floats tMin, Mask inCell, Found& found) {
    for (std::uint32_t i = leaf.common; i < leaf.count; ++i)
        testNarrowTriangle<kSearch>(scene, cornersOf(scene, leaf, i), along, rays, tMin, inCell, found);
}

/// The same for some of a leaf's narrow triangles: a bit of `which` for each from its reference `first` on.
template <Search kSearch, typename Along>
HWY_NOINLINE void testNarrowTriangles(const KernelScene& scene, const Leaf& leaf, std::uint32_t first,
                                      std::uint32_t which, const Along& along, const ShearedRays& rays,
                                      Floats tMin, Mask inCell, Found& found) {
    for (; which != 0; which &= which - 1) {
        const auto i = first + static_cast<std::uint32_t>(std::countr_zero(which));
        testNarrowTriangle<kSearch>(scene, cornersOf(scene, leaf, i), along, rays, tMin, inCell, found);
    }
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
