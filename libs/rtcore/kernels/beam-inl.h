// A beam: some rays of one dominant axis, by the bounds of their directions and places, and which triangles
// they may meet. Included once for each target.
#if defined(RTCORE_KERNELS_BEAM_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_KERNELS_BEAM_INL_H_
#undef RTCORE_KERNELS_BEAM_INL_H_
#else
#define RTCORE_KERNELS_BEAM_INL_H_
#endif

#include "rtcore/kernels/leaf_test-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// Bounds, the lower one first, of the rays' shears (ShearedRays::sx, sy) and of where they pass the level of
/// a point: how far from it, along the axes of these, and as the point minus that place. Widened by more than
/// what rounding does to the leaf test.
struct Beam {
    static constexpr float kWider =
        0x1p-20F; ///< than shears, where |sx|, |sy| <= 1; of distances from the point
    float shear[2][2];
    float place[2][2] = {}; ///< all 0 where all rays pass through the point
};

/// The triangles of a leaf, some at a time, as seen from a point.
class SeenTriangles {
  public:
    static constexpr std::size_t kMax = 32;

    /// Those of the leaf's references from `first` to before `last`, as many as there is room for.
    HWY_INLINE SeenTriangles(const KernelScene& scene, const Leaf& leaf, std::uint32_t first,
                             std::uint32_t last, Vec3 point)
        : count(std::min<std::size_t>(last - first, kMax)) {
        const FloatTag d;
        if (scene.records == nullptr) {
            for (std::size_t i = 0; i < count; ++i)
                take(cornersOf(scene, leaf, first + static_cast<std::uint32_t>(i)), i, point);
            return;
        }
        const float* const records = scene.records + kFloatsPerRecord * leaf.first + first;
        for (std::size_t c = 0; c < 9; ++c) {
            const Floats from = hn::Set(d, point[static_cast<int>(c % 3)]);
            for (std::size_t i = 0; i < count; i += kLanes)
                hn::Store(hn::Sub(from, hn::LoadU(d, records + c * leaf.count + i)), d, offsets_[c] + i);
        }
        const auto* const indices =
            reinterpret_cast<const std::int32_t*>(records + 9 * std::size_t{leaf.count});
        const IntTag di;
        for (std::size_t i = 0; i < count; i += kLanes)
            hn::Store(hn::LoadU(di, indices + i), di, triangle + i);
    }

    /// Offsets of the point from corner `c` along `axis`, by triangle.
    HWY_INLINE const float* offsets(std::size_t c, int axis) const {
        return offsets_[3 * c + static_cast<std::size_t>(axis)];
    }

    std::size_t count;
    alignas(64) std::int32_t triangle[kMax];

  private:
    HWY_INLINE void take(const Corners& corners, std::size_t i, Vec3 point) {
        std::size_t c = 0;
        for (const float* const corner : {corners.a, corners.b, corners.c}) {
            for (int axis = 0; axis < 3; ++axis)
                offsets_[c++][i] = point[axis] - corner[static_cast<std::size_t>(axis) * corners.stride];
        }
        triangle[i] = corners.triangle;
    }

    alignas(64) float offsets_[9][kMax];
};

/// Which triangles rays of each beam may meet, a bit for each. `triangles` as seen from their point;
/// `kThroughPoint`: all rays pass through it.
template <bool kThroughPoint, std::size_t kBeams>
HWY_INLINE void findCandidates(const SeenTriangles& triangles, const AlongAxis& along, const Beam* beams,
                               std::uint32_t (&found)[kBeams]) {
    const FloatTag d;
    for (std::uint32_t& bits : found) bits = 0;
    for (std::size_t i = 0; i < triangles.count; i += kLanes) {
        Floats corners[3][3];
        for (std::size_t c = 0; c < 3; ++c) {
            corners[0][c] = hn::Load(d, triangles.offsets(c, along.kx) + i);
            corners[1][c] = hn::Load(d, triangles.offsets(c, along.ky) + i);
            corners[2][c] = hn::Load(d, triangles.offsets(c, along.kz) + i);
        }
        const auto apart = [&](const Floats(&across)[3], const float(&shears)[2],
                               const float(&places)[2]) HWY_ATTR {
            Floats min = hn::Set(d, std::numeric_limits<float>::max()), max = hn::Neg(min);
            for (const float shear : shears) {
                for (std::size_t c = 0; c < 3; ++c) {
                    // Fused or not: this only culls.
                    const Floats place = hn::NegMulAdd(hn::Set(d, shear), corners[2][c], across[c]);
                    min = hn::Min(min, place);
                    max = hn::Max(max, place);
                }
            }
            return hn::Or(hn::Gt(min, kThroughPoint ? hn::Zero(d) : hn::Set(d, places[1])),
                          hn::Lt(max, kThroughPoint ? hn::Zero(d) : hn::Set(d, places[0])));
        };
        for (std::size_t b = 0; b < kBeams; ++b) {
            const Beam& beam = beams[b];
            const Mask out = hn::Or(apart(corners[0], beam.shear[0], beam.place[0]),
                                    apart(corners[1], beam.shear[1], beam.place[1]));
            found[b] |= bitsOf(hn::Not(out)) << i;
        }
    }
    for (std::uint32_t& bits : found) bits &= ~std::uint32_t{0} >> (SeenTriangles::kMax - triangles.count);
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
