// One ray against a vector of triangles: for leaves that few rays of a packet reach. The same expressions as
// leaf_test-inl.h, so the same bits. Included once for each target.
#if defined(RTCORE_KERNELS_TRIANGLE_BLOCK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_KERNELS_TRIANGLE_BLOCK_INL_H_
#undef RTCORE_KERNELS_TRIANGLE_BLOCK_INL_H_
#else
#define RTCORE_KERNELS_TRIANGLE_BLOCK_INL_H_
#endif

#include "rtcore/kernels/leaf_test-inl.h"
#include "rtcore/kernels/narrow_noise.h"
#include "rtcore/kernels/precise_hit.h"

#include <algorithm>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// Closest hit of one ray so far.
struct FoundByRay {
    float best; ///< for any hit tMax, or -1 once hit
    std::int32_t triangle;
    float v, w, det;
    float tie = 0;       ///< closest hit: as in Found
    bool passed = false; ///< any hit: through a triangle that lets light through
};

/// Keeps a hit as keepHits() does; true where it counts.
HWY_INLINE bool keepHit(const FoundByRay& hit, FoundByRay& found) {
    if (hit.triangle == found.triangle || !(hit.best <= found.best + found.tie)) return false;
    const bool tied = hit.best >= found.best - found.tie;
    found = {std::min(hit.best, found.best),
             tied ? hit.triangle | kTied : hit.triangle,
             hit.v,
             hit.w,
             hit.det,
             found.tie};
    return true;
}

/// Triangles of a leaf, as many as a vector has lanes, one array for each coordinate.
class TriangleBlock {
  public:
    HWY_INLINE TriangleBlock(const KernelScene& scene, const Leaf& leaf) : scene_(scene), leaf_(leaf) {}

    /// Those from the leaf's reference `first` on, at most to before `last`: all common or all narrow.
    HWY_INLINE void load(std::uint32_t first, std::uint32_t last) {
        first_ = first;
        count_ = std::min(last - first, static_cast<std::uint32_t>(kLanes));
        if (scene_.records != nullptr) {
            const float* const records = scene_.records + kFloatsPerRecord * leaf_.first + first;
            for (std::size_t i = 0; i < 9; ++i) coordinates_[i] = records + i * leaf_.count;
            triangle_ = reinterpret_cast<const std::int32_t*>(records + 9 * std::size_t{leaf_.count});
        } else {
            gather();
            triangle_ = reinterpret_cast<const std::int32_t*>(scene_.references + leaf_.first + first);
        }
    }

    /// The corners of triangle `i` of the block.
    HWY_INLINE Corners corners(std::uint32_t i) const { return cornersOf(scene_, leaf_, first_ + i); }

    /// For common triangles: returns whether the ray hits one of them, closer than its hit so far or as
    /// close.
    template <Search kSearch>
    HWY_INLINE bool test(const ShearedRay& ray, float tMin, FoundByRay& found) const {
        const FloatTag d;
        const Outcome outcome = edgeTestOf(ray);
        const Floats farthest = hn::Set(d, kSearch.any ? found.best : found.best + found.tie);
        Mask open = hn::And(hn::And(outcome.inside, hn::FirstN(d, count_)),
                            hn::And(hn::Ge(outcome.t, hn::Set(d, tMin)), hn::Le(outcome.t, farthest)));
        if (hn::AllFalse(d, open)) return false;
        if constexpr (kSearch.filtered) {
            open = hitsOf(open, outcome);
            if (hn::AllFalse(d, open)) return false;
        }
        if constexpr (kSearch.any) {
            if (kSearch.filtered && scene_.clear != nullptr) return testOpaque(open, found);
            found.best = -1;
            found.triangle = static_cast<std::int32_t>(firstOf(open));
            return true;
        }
        alignas(64) float hits[4][kLanes];
        hn::Store(outcome.t, d, hits[0]);
        hn::Store(outcome.v, d, hits[1]);
        hn::Store(outcome.w, d, hits[2]);
        hn::Store(outcome.det, d, hits[3]);
        bool hit = false;
        forEachLane(open, [&](std::size_t lane) {
            hit |=
                keepHit({hits[0][lane], triangle_[lane], hits[1][lane], hits[2][lane], hits[3][lane]}, found);
        });
        return hit;
    }

    /// The same of narrow triangles. For any hit `found.triangle` is left alone.
    template <Search kSearch>
    HWY_INLINE bool testNarrow(const ShearedRay& ray, float tMin, FoundByRay& found) const {
        const FloatTag d;
        const Outcome outcome = edgeTestOf(ray);
        const Mask inside = hn::And(outcome.inside, hn::FirstN(d, count_));
        if (hn::AllFalse(d, inside)) return false;
        bool hit = false;
        forEachLane(inside, [&](std::size_t lane) {
            const FoundByRay here = narrowHit(outcome, lane, ray);
            const float farthest = kSearch.any ? found.best : found.best + found.tie;
            if (!(here.best >= tMin && here.best <= farthest)) return;
            if (kSearch.filtered && !isHit(here)) return;
            if constexpr (kSearch.any) {
                const bool passed = kSearch.filtered && scene_.clear != nullptr &&
                                    scene_.letsThrough(static_cast<std::uint32_t>(here.triangle));
                found.passed |= passed;
                if (passed) return;
                found.best = -1;
                hit = true;
            } else {
                hit |= keepHit(here, found);
            }
        });
        return hit;
    }

  private:
    HWY_INLINE Outcome edgeTestOf(const ShearedRay& ray) const {
        const FloatTag d;
        const ShearedRays rays{hn::Set(d, ray.x),  hn::Set(d, ray.y),  hn::Set(d, ray.z),
                               hn::Set(d, ray.sx), hn::Set(d, ray.sy), hn::Set(d, ray.minusSz)};
        return edgeTest(offset(0, ray, rays), offset(1, ray, rays), offset(2, ray, rays), rays);
    }

    /// Where the ray meets the narrow triangle in `lane`.
    HWY_INLINE FoundByRay narrowHit(const Outcome& outcome, std::size_t lane, const ShearedRay& ray) const {
        const std::int32_t triangle = triangle_[lane];
        if (!isDoubtful(laneOf(outcome.sum, lane), scene_.noise[triangle])) {
            return {laneOf(outcome.t, lane), triangle, laneOf(outcome.v, lane), laneOf(outcome.w, lane),
                    laneOf(outcome.det, lane)};
        }
        const auto corner = [&](int c) {
            const float* const* const xyz = coordinates_ + 3 * c;
            return Vec3{xyz[0][lane], xyz[1][lane], xyz[2][lane]};
        };
        const PreciseHit hit = preciseHit(ray, corner(0), corner(1), corner(2));
        return {hit.t, triangle, hit.v, hit.w, 1};
    }

    /// Whether a ray that meets the triangle hits it.
    HWY_INLINE bool isHit(const FoundByRay& candidate) const {
        return scene_.filter.keeps(static_cast<std::uint32_t>(candidate.triangle),
                                   candidate.v / candidate.det, candidate.w / candidate.det);
    }

    /// Those of the triangles `candidates`, which the ray meets, that it hits.
    HWY_INLINE Mask hitsOf(Mask candidates, const Outcome& outcome) const {
        return scene_.filter.empty() ? candidates : keptOf(candidates, outcome);
    }
    HWY_NOINLINE Mask keptOf(Mask candidates, const Outcome& outcome) const {
        const IntTag di;
        const Holes* const holes = scene_.filter.holes;
        alignas(64) std::int32_t kept[kLanes] = {};
        forEachLane(candidates, [&](std::size_t lane) {
            const auto triangle = static_cast<std::uint32_t>(triangle_[lane]);
            if (scene_.filter.hides(triangle)) return;
            const auto weight = [&](Floats area) { return laneOf(area, lane) / laneOf(outcome.det, lane); };
            const bool isHole =
                holes != nullptr && holes->isHole(triangle, weight(outcome.v), weight(outcome.w));
            kept[lane] = isHole ? 0 : 1;
        });
        return hn::RebindMask(FloatTag(), hn::Ne(hn::Load(di, kept), hn::Zero(di)));
    }

    /// Whether one of the triangles `open`, which the ray hits, stops it: all that let no light through do.
    HWY_NOINLINE bool testOpaque(Mask open, FoundByRay& found) const {
        bool stopped = false;
        forEachLane(open, [&](std::size_t lane) {
            if (scene_.letsThrough(static_cast<std::uint32_t>(triangle_[lane]))) {
                found.passed = true;
            } else if (!stopped) {
                stopped = true;
                found.best = -1;
                found.triangle = static_cast<std::int32_t>(lane);
            }
        });
        return stopped;
    }

    /// Copies the corners from the mesh.
    HWY_INLINE void gather() {
        const hn::CappedTag<float, 4> d4;
        for (std::uint32_t i = 0; i < count_; ++i) {
            const Corners from = corners(i);
            hn::Store(hn::Load(d4, from.a), d4, rows_[0] + std::size_t{i} * 4);
            hn::Store(hn::Load(d4, from.b), d4, rows_[1] + std::size_t{i} * 4);
            hn::Store(hn::Load(d4, from.c), d4, rows_[2] + std::size_t{i} * 4);
        }
        const FloatTag d;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            Floats x;
            Floats y;
            Floats z;
            Floats unused;
            hn::LoadInterleaved4(d, rows_[corner], x, y, z, unused);
            hn::Store(x, d, columns_[3 * corner]);
            hn::Store(y, d, columns_[3 * corner + 1]);
            hn::Store(z, d, columns_[3 * corner + 2]);
        }
        for (std::size_t i = 0; i < 9; ++i) coordinates_[i] = columns_[i];
    }

    HWY_INLINE Offset offset(int corner, const ShearedRay& ray, const ShearedRays& rays) const {
        const FloatTag d;
        return {hn::Sub(rays.x, hn::LoadU(d, coordinates_[3 * corner + ray.kx])),
                hn::Sub(rays.y, hn::LoadU(d, coordinates_[3 * corner + ray.ky])),
                hn::Sub(rays.z, hn::LoadU(d, coordinates_[3 * corner + ray.kz]))};
    }
    HWY_INLINE static std::size_t firstOf(Mask lanes) {
        return static_cast<std::size_t>(hn::FindFirstTrue(FloatTag(), lanes));
    }
    HWY_INLINE static float laneOf(Floats values, std::size_t lane) {
        alignas(64) float all[kLanes];
        hn::Store(values, FloatTag(), all);
        return all[lane];
    }

    const KernelScene& scene_;
    const Leaf leaf_;
    std::uint32_t first_ = 0, count_ = 0;
    const float* coordinates_[9];  ///< x, y, z of the first corners, of the second, of the third
    const std::int32_t* triangle_; ///< their indices
    alignas(64) float rows_[3][kLanes * 4];
    alignas(64) float columns_[9][kLanes];
};

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
