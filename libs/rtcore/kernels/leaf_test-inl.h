// One triangle against a vector of rays: watertight.h, with the same bits. Included once for each target.
#if defined(RTCORE_KERNELS_LEAF_TEST_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_KERNELS_LEAF_TEST_INL_H_
#undef RTCORE_KERNELS_LEAF_TEST_INL_H_
#else
#define RTCORE_KERNELS_LEAF_TEST_INL_H_
#endif

#include "rtcore/kernels/leaf_records.h"
#include "rtcore/kernels/wave_kernels.h"

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = hn::ScalableTag<float>;
using IntTag = hn::ScalableTag<std::int32_t>;
using ByteTag = hn::ScalableTag<std::uint8_t>;
using Floats = hn::Vec<FloatTag>;
using Ints = hn::Vec<IntTag>;
using Bytes = hn::Vec<ByteTag>;
using Mask = hn::Mask<FloatTag>; ///< which lanes something holds for
constexpr std::size_t kLanes = hn::MaxLanes(FloatTag());

/// While a kernel works, "no triangle" is the largest index, so that comparisons of signed numbers order it.
constexpr std::int32_t kNone = std::numeric_limits<std::int32_t>::max();

/// In a triangle's number: kTiedHit.
constexpr std::int32_t kTied = std::numeric_limits<std::int32_t>::min();
static_assert(static_cast<std::uint32_t>(kTied) == kTiedHit);

/// The property that the rays of a packet share, which decides how corners are brought to them.
enum class Shared {
    Origin, ///< the origin and the dominant axis
    Axis,   ///< the dominant axis
    Nothing
};

/// The kind of hit that is looked for along rays.
struct Search {
    bool any;      ///< whether there is a hit; else the closest
    bool filtered; ///< not all candidates are hits: by KernelScene's filter and `clear`
};

/// The references of a leaf, those to narrow triangles last.
struct Leaf {
    HWY_INLINE Leaf(const KernelScene& scene, KdNode node)
        : first(node.firstReference), count(node.count()), common(count) {
        if (scene.narrowBits == nullptr) return;
        while (HWY_UNLIKELY(common > 0 && isBitSet(scene.narrowBits, std::size_t{first} + common - 1)))
            --common;
    }

    std::uint32_t first, count;
    std::uint32_t common; ///< so many are not narrow
};

/// Where the corners of a triangle are: the coordinates of each lie `stride` apart.
struct Corners {
    const float *a = nullptr, *b = nullptr, *c = nullptr;
    std::size_t stride = 1;
    std::int32_t triangle = kNone;
};

HWY_INLINE Corners cornersOf(const KernelScene& scene, const Leaf& leaf, std::uint32_t i) {
    if (scene.records != nullptr) {
        const std::size_t count = leaf.count;
        const float* const a = scene.records + kFloatsPerRecord * leaf.first + i;
        return {a, a + 3 * count, a + 6 * count, count, std::bit_cast<std::int32_t>(a[9 * count])};
    }
    const std::uint32_t index = scene.references[leaf.first + i];
    const Triangle& triangle = scene.triangles[index];
    return {&scene.vertices[triangle.v[0]].x, &scene.vertices[triangle.v[1]].x,
            &scene.vertices[triangle.v[2]].x, 1, static_cast<std::int32_t>(index)};
}

/// If the node is a leaf, sends for the corners of its triangles before they are needed.
HWY_INLINE void sendForLeaf(const KernelScene& scene, KdNode node) {
    if (scene.records == nullptr || !node.isLeaf()) return;
    constexpr std::size_t kMax = 640, kCacheLine = 64; // bytes
    const auto* const records =
        reinterpret_cast<const char*>(scene.records + kFloatsPerRecord * node.firstReference);
    const std::size_t bytes = std::min(kFloatsPerRecord * sizeof(float) * node.count(), kMax);
    for (std::size_t at = 0; at < bytes; at += kCacheLine) hwy::Prefetch(records + at);
}

/// The dominant axis of each lane as RayShear chooses it, and how to bring the coordinates of a vector (x, y,
/// z, -) into the order (kx, ky, kz).
struct AxisOrder {
    Bytes x, y, z; ///< for TableLookupBytes
    Mask isX, isY;

    HWY_INLINE AxisOrder(Floats dx, Floats dy, Floats dz) {
        const IntTag di;
        const Floats ax = hn::Abs(dx);
        const Floats ay = hn::Abs(dy);
        const Floats az = hn::Abs(dz);
        isX = hn::And(hn::Gt(ax, ay), hn::Gt(ax, az));
        isY = hn::AndNot(hn::Gt(ax, ay), hn::Gt(ay, az));
        // Byte positions of one coordinate's float inside its vertex.
        constexpr std::int32_t kX = 0x03020100;
        constexpr std::int32_t kY = 0x07060504;
        constexpr std::int32_t kZ = 0x0B0A0908;
        const auto order = [&](std::int32_t forX, std::int32_t forY, std::int32_t forZ) HWY_ATTR {
            const Ints i =
                hn::IfThenElse(hn::RebindMask(di, isX), hn::Set(di, forX),
                               hn::IfThenElse(hn::RebindMask(di, isY), hn::Set(di, forY), hn::Set(di, forZ)));
            return hn::BitCast(ByteTag(), i);
        };
        x = order(kY, kZ, kX);
        y = order(kZ, kX, kY);
        z = order(kX, kY, kZ);
    }
    /// 0, 1, 2 where that is the axis of all lanes; else 3.
    HWY_INLINE int common() const {
        const FloatTag d;
        if (hn::AllTrue(d, isX)) return 0;
        if (hn::AllTrue(d, isY)) return 1;
        return hn::AllFalse(d, hn::Or(isX, isY)) ? 2 : 3;
    }
    HWY_INLINE Floats choose(Floats forX, Floats forY, Floats forZ) const {
        return hn::IfThenElse(isX, forX, hn::IfThenElse(isY, forY, forZ));
    }
};

/// A vector of rays as the leaf test wants them: origin and shear in the order of the dominant axis.
struct ShearedRays {
    Floats x, y, z;
    Floats sx, sy, minusSz;
};

HWY_INLINE ShearedRays shear(const AxisOrder& order, Floats ox, Floats oy, Floats oz, Floats dx, Floats dy,
                             Floats dz) {
    const Floats along = order.choose(dx, dy, dz);
    return {order.choose(oy, oz, ox),
            order.choose(oz, ox, oy),
            order.choose(ox, oy, oz),
            hn::Div(order.choose(dy, dz, dx), along),
            hn::Div(order.choose(dz, dx, dy), along),
            hn::Div(hn::Set(FloatTag(), -1.0F), along)};
}

/// Origin minus corner in the order of the dominant axis. (This way round a corner's coordinate can be
/// fetched by the subtraction.)
struct Offset {
    Floats x, y, z;
};

/// Brings corners to rays that share their dominant axis `kz`.
struct AlongAxis {
    int kx, ky, kz;

    HWY_INLINE Offset offset(const float* corner, std::size_t stride, const ShearedRays& rays) const {
        const FloatTag d;
        return {hn::Sub(rays.x, hn::Set(d, corner[static_cast<std::size_t>(kx) * stride])),
                hn::Sub(rays.y, hn::Set(d, corner[static_cast<std::size_t>(ky) * stride])),
                hn::Sub(rays.z, hn::Set(d, corner[static_cast<std::size_t>(kz) * stride]))};
    }
};

/// Brings corners to rays of any axis.
struct AlongEach {
    const AxisOrder& order;

    HWY_INLINE Offset offset(const float* corner, std::size_t stride, const ShearedRays& rays) const {
        const FloatTag d;
#if HWY_TARGET != HWY_SCALAR // whose vectors have room for one byte
        if (stride == 1) {
            const Bytes all = hn::BitCast(ByteTag(), hn::LoadDup128(d, corner));
            return {hn::Sub(rays.x, hn::BitCast(d, hn::TableLookupBytes(all, order.x))),
                    hn::Sub(rays.y, hn::BitCast(d, hn::TableLookupBytes(all, order.y))),
                    hn::Sub(rays.z, hn::BitCast(d, hn::TableLookupBytes(all, order.z)))};
        }
#endif
        const Floats x = hn::Set(d, corner[0]);
        const Floats y = hn::Set(d, corner[stride]);
        const Floats z = hn::Set(d, corner[2 * stride]);
        return {hn::Sub(rays.x, order.choose(y, z, x)), hn::Sub(rays.y, order.choose(z, x, y)),
                hn::Sub(rays.z, order.choose(x, y, z))};
    }
};

/// Result of the test of one triangle for each lane.
struct Outcome {
    Mask inside; ///< the ray's line meets the triangle
    Floats t;    ///< where; NaN or any other number outside
    Floats v, w, det;
    Floats sum; ///< of the corners' distances, weighted by the edge functions
};

HWY_INLINE Outcome edgeTest(Offset a, Offset b, Offset c, const ShearedRays& rays) {
    const FloatTag d;
    const Floats ax = hn::Sub(a.x, hn::Mul(rays.sx, a.z));
    const Floats ay = hn::Sub(a.y, hn::Mul(rays.sy, a.z));
    const Floats bx = hn::Sub(b.x, hn::Mul(rays.sx, b.z));
    const Floats by = hn::Sub(b.y, hn::Mul(rays.sy, b.z));
    const Floats cx = hn::Sub(c.x, hn::Mul(rays.sx, c.z));
    const Floats cy = hn::Sub(c.y, hn::Mul(rays.sy, c.z));
    const Floats u = hn::Sub(hn::Mul(cx, by), hn::Mul(cy, bx));
    const Floats v = hn::Sub(hn::Mul(ax, cy), hn::Mul(ay, cx));
    const Floats w = hn::Sub(hn::Mul(bx, ay), hn::Mul(by, ax));
    const Floats zero = hn::Zero(d);
    const Mask front = hn::Ge(hn::Min(hn::Min(u, v), w), zero);
    const Mask back = hn::Le(hn::Max(hn::Max(u, v), w), zero);
    const Floats det = hn::Add(hn::Add(u, v), w);
    const Mask seen = hn::Ge(hn::Abs(det), hn::Set(d, std::numeric_limits<float>::min()));
    const Floats sum = hn::Add(hn::Add(hn::Mul(u, a.z), hn::Mul(v, b.z)), hn::Mul(w, c.z));
    return {hn::And(hn::Or(front, back), seen), hn::Div(hn::Mul(sum, rays.minusSz), det), v, w, det, sum};
}

/// Closest hits of a vector of rays so far.
struct Found {
    Floats best;      ///< distance of the closest hit; for any hit tMax, or -1 once hit
    Ints triangle;    ///< with kTied, one of several as close, of which only `best` is known
    Floats v, w, det; ///< only of the lanes in `changed`
    Mask changed;     ///< by the leaf
    Mask passed;      ///< any hit: through triangles that let light through
    Floats tie;       ///< closest hit: others no further from `best` than this are ties; any hit: unused
};

template <typename Along>
HWY_INLINE Outcome edgeTest(const Corners& corners, const Along& along, const ShearedRays& rays) {
    return edgeTest(along.offset(corners.a, corners.stride, rays),
                    along.offset(corners.b, corners.stride, rays),
                    along.offset(corners.c, corners.stride, rays), rays);
}

/// A bit for each lane.
HWY_INLINE std::uint32_t bitsOf(Mask lanes) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(FloatTag(), lanes, bytes);
    return std::uint32_t{bytes[0]} | std::uint32_t{bytes[1]} << 8U;
}

/// Calls `work` with the number of each lane that `lanes` holds.
template <typename Work>
HWY_INLINE void forEachLane(Mask lanes, Work&& work) {
    for (std::uint32_t bits = bitsOf(lanes); bits != 0; bits &= bits - 1)
        work(static_cast<std::size_t>(std::countr_zero(bits)));
}

/// Whether no ray of the search hits the triangle.
template <Search kSearch>
HWY_INLINE bool isHidden(const KernelScene& scene, std::int32_t triangle) {
    if constexpr (!kSearch.filtered) return false;
    return scene.filter.hides(static_cast<std::uint32_t>(triangle));
}

/// Those of the rays `candidates`, which meet the triangle, that pass through no hole of it.
inline HWY_NOINLINE Mask besideHoles(const Holes& holes, std::int32_t triangle, Mask candidates,
                                     const Outcome& outcome) {
    const FloatTag d;
    const IntTag di;
    alignas(64) float u[kLanes];
    alignas(64) float v[kLanes];
    alignas(64) std::int32_t kept[kLanes] = {};
    hn::Store(hn::Div(outcome.v, outcome.det), d, u);
    hn::Store(hn::Div(outcome.w, outcome.det), d, v);
    forEachLane(candidates, [&](std::size_t lane) {
        kept[lane] = holes.isHole(static_cast<std::uint32_t>(triangle), u[lane], v[lane]) ? 0 : 1;
    });
    return hn::RebindMask(d, hn::Ne(hn::Load(di, kept), hn::Zero(di)));
}

/// Lets only those rays be inside of a triangle that pass through no hole of it.
template <Search kSearch>
HWY_INLINE void filter(const KernelScene& scene, std::int32_t triangle, Floats tMin, Mask inCell,
                       const Found& found, Outcome& outcome) {
    if constexpr (!kSearch.filtered) return;
    const FloatTag d;
    if (scene.filter.holes == nullptr) return;
    const Floats farthest = kSearch.any ? found.best : hn::Add(found.best, found.tie);
    const Mask within = hn::And(hn::Ge(outcome.t, tMin), hn::Le(outcome.t, farthest));
    const Mask candidates = hn::And(hn::And(outcome.inside, inCell), within);
    outcome.inside = hn::AllFalse(d, candidates)
                         ? candidates
                         : besideHoles(*scene.filter.holes, triangle, candidates, outcome);
}

/// Keeps what the test of `triangle` says of the rays in `inCell`, from `tMin` on. Returns the rays that hit
/// it (for any hit `triangle`, v, w, det are left alone).
template <Search kSearch>
HWY_INLINE Mask keepHits(const Outcome& outcome, std::int32_t triangle, Floats tMin, Mask inCell,
                         Found& found) {
    const FloatTag d;
    const IntTag di;
    const Mask open = hn::And(hn::And(outcome.inside, inCell), hn::Ge(outcome.t, tMin));
    Mask hit = open;
    if constexpr (kSearch.any) {
        hit = hn::And(open, hn::Le(outcome.t, found.best));
        found.best = hn::IfThenElse(hit, hn::Set(d, -1.0F), found.best);
    } else {
        // A triangle is met once more in each leaf that has it.
        const Ints index = hn::Set(di, triangle);
        const Mask same = hn::RebindMask(d, hn::Eq(index, found.triangle));
        const Floats behind = hn::Sub(outcome.t, found.best);
        hit = hn::AndNot(hn::Or(same, hn::Gt(behind, found.tie)), open);
        const Mask nearest = hn::Lt(behind, hn::Neg(found.tie));
        const Ints mark = hn::IfThenZeroElse(hn::RebindMask(di, nearest), hn::Set(di, kTied));
        found.best = hn::IfThenElse(hit, hn::Min(outcome.t, found.best), found.best);
        found.triangle = hn::IfThenElse(hn::RebindMask(di, hit), hn::Or(index, mark), found.triangle);
        found.v = hn::IfThenElse(hit, outcome.v, found.v);
        found.w = hn::IfThenElse(hit, outcome.w, found.w);
        found.det = hn::IfThenElse(hit, outcome.det, found.det);
    }
    found.changed = hn::Or(found.changed, hit);
    return hit;
}

/// Whether a triangle stops no ray of a search for any hit.
template <Search kSearch>
HWY_INLINE bool isPassed(const KernelScene& scene, const Corners& corners) {
    if constexpr (!kSearch.any || !kSearch.filtered) return false;
    return scene.clear != nullptr && scene.letsThrough(static_cast<std::uint32_t>(corners.triangle));
}

/// Keeps which of the rays in `inCell` pass through a triangle that lets light through.
HWY_INLINE void keepPassed(const Outcome& outcome, Floats tMin, Mask inCell, Found& found) {
    const Mask within = hn::And(hn::Ge(outcome.t, tMin), hn::Le(outcome.t, found.best));
    found.passed = hn::Or(found.passed, hn::And(hn::And(outcome.inside, inCell), within));
}

/// Tests one triangle, which must not be narrow, against a vector of rays.
template <Search kSearch, typename Along>
HWY_INLINE Mask testTriangle(const KernelScene& scene, const Corners& corners, const Along& along,
                             const ShearedRays& rays, Floats tMin, Mask inCell, Found& found) {
    if (isHidden<kSearch>(scene, corners.triangle)) return hn::FirstN(FloatTag(), 0);
    Outcome outcome = edgeTest(corners, along, rays);
    filter<kSearch>(scene, corners.triangle, tMin, inCell, found, outcome);
    if (isPassed<kSearch>(scene, corners)) {
        keepPassed(outcome, tMin, inCell, found);
        return hn::FirstN(FloatTag(), 0);
    }
    return keepHits<kSearch>(outcome, corners.triangle, tMin, inCell, found);
}

HWY_INLINE AlongAxis alongAxis(int kz) { return {kz == 2 ? 0 : kz + 1, kz == 0 ? 2 : kz - 1, kz}; }

/// Tests the common triangle `i` of a leaf. For any hit `onHit` gets its corners where it was hit.
template <Search kSearch, typename Along, typename OnHit>
HWY_INLINE void testCommon(const KernelScene& scene, const Leaf& leaf, std::uint32_t i, const Along& along,
                           const ShearedRays& rays, Floats tMin, Mask inCell, Found& found,
                           const OnHit& onHit) {
    const Corners corners = cornersOf(scene, leaf, i);
    const Mask hit = testTriangle<kSearch>(scene, corners, along, rays, tMin, inCell, found);
    if constexpr (kSearch.any) {
        if (!hn::AllFalse(FloatTag(), hit)) onHit(corners);
    }
}

/// The same for all of them.
template <Search kSearch, typename Along, typename OnHit>
HWY_INLINE void testTriangles(const KernelScene& scene, const Leaf& leaf, const Along& along,
                              const ShearedRays& rays, Floats tMin, Mask inCell, Found& found,
                              const OnHit& onHit) {
    for (std::uint32_t i = 0; i < leaf.common; ++i)
        testCommon<kSearch>(scene, leaf, i, along, rays, tMin, inCell, found, onHit);
}

/// The minimum; the second where either is NaN.
HWY_INLINE Floats min(Floats a, Floats b) {
#if HWY_ARCH_X86
    return hn::Min(a, b);
#else
    return hn::IfThenElse(hn::Lt(a, b), a, b);
#endif
}

/// The maximum; the second where either is NaN.
HWY_INLINE Floats max(Floats a, Floats b) {
#if HWY_ARCH_X86
    return hn::Max(a, b);
#else
    return hn::IfThenElse(hn::Gt(a, b), a, b);
#endif
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
