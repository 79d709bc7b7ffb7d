// Groups of rays that go as bundles, where that takes less time. Included once for each target.
#if defined(RTCORE_KERNELS_BUNDLE_TRACER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_KERNELS_BUNDLE_TRACER_INL_H_
#undef RTCORE_KERNELS_BUNDLE_TRACER_INL_H_
#else
#define RTCORE_KERNELS_BUNDLE_TRACER_INL_H_
#endif

#include "rtcore/kernels/bundle-inl.h"
#include "rtcore/kernels/bundle_choice.h"
#include "rtcore/kernels/packet_tracer-inl.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// Gathers packets of one origin and traces them together, where that takes less time than one by one.
template <Search kSearch, typename Output>
class BundleTracer {
  public:
    BundleTracer(const KernelScene& scene, const RaySpan& rays, const Output& output)
        : scene_(scene), rays_(rays), output_(output), walk_(scene, bundle_) {}

    /// Takes a whole group of much the same direction from `first` on, if it can be bundled. `asPacket(shape,
    /// first)` traces one alone.
    template <typename AsPacket>
    HWY_INLINE bool take(const GroupShape& shape, std::size_t first, BundleChoice& choice,
                         const AsPacket& asPacket) {
        if (!haveCommonOrigin(rays_, first) || !shape.oneOctant()) return false;
        const int axis = commonAxis(shape, rays_, first);
        if (axis == 3) return false;
        const Vec3 origin{rays_.origin[0][first], rays_.origin[1][first], rays_.origin[2][first]};
        const bool negative[3] = {shape.direction[0].hi < 0, shape.direction[1].hi < 0,
                                  shape.direction[2].hi < 0};
        if (gathered_ == kBundle || (gathered_ > 0 && !bundle_.suits(origin, negative))) finish(choice);
        if (gathered_++ == 0) {
            bundle_.origin = origin;
            std::copy_n(negative, 3, bundle_.negative);
            asBundle_ = choice.next();
        }
        if (asBundle_) {
            add(shape, alongAxis(axis), first);
        } else {
            asPacket(shape, first);
        }
        return true;
    }

    /// Traces what has been gathered.
    HWY_INLINE void finish(BundleChoice& choice) {
        if (gathered_ == 0) return;
        if (asBundle_) run();
        const Clock::time_point now = Clock::now();
        const std::chrono::duration<double> time = now - std::exchange(start_, now);
        // Few take longer each, and tell nothing.
        if (gathered_ >= kBundle / 2) choice.learn(time.count() / static_cast<double>(gathered_));
        gathered_ = 0;
    }

  private:
    using Clock = std::chrono::steady_clock;

    HWY_NOINLINE void run() {
        if (bundle_.size == 0) return;
        for (std::size_t p = bundle_.size; p < kBundle; ++p) {
            bundle_.begin[p] = 1;
            bundle_.end[p] = -1;
        }
        walk_.run();
        for (std::size_t p = 0; p < bundle_.size; ++p)
            output_.fromPacket(bundle_.packets[p], bundle_.packets[p].first, kGroup);
        bundle_.size = 0;
    }

    HWY_INLINE void add(const GroupShape& shape, const AlongAxis& along, std::size_t first) {
        const FloatTag d;
        BundledPacket& packet = bundle_.packets[bundle_.size];
        packet.first = first;
        packet.along = along;
        Floats nearest = hn::Set(d, std::numeric_limits<float>::infinity()), farthest = hn::Zero(d);
        for (std::size_t i = 0; i < kGroup; i += kLanes) {
            const RayVector ray = loadRays(rays_, first + i);
            nearest = hn::Min(nearest, ray.tMin);
            farthest = hn::Max(farthest, ray.tMax);
            beginSearch<false>(ray, packet, i);
        }
        const Range interval{hn::GetLane(hn::MinOfLanes(d, nearest)),
                             hn::GetLane(hn::MaxOfLanes(d, farthest))};
        if (!enter(shape, along.kz, interval)) {
            output_.fromPacket(packet, first, kGroup);
            return;
        }
        shearRays(packet);
        ++bundle_.size;
    }

    /// The packet's place in the tree; false where it misses the box.
    HWY_INLINE bool enter(const GroupShape& shape, int dominant, const Range& interval) {
        const std::size_t p = bundle_.size;
        float far = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const float o = bundle_.origin[axis];
            far += std::max(std::fabs(scene_.lo[axis] - o), std::fabs(scene_.hi[axis] - o));
        }
        const Range& along = shape.direction[dominant];
        // As slackOf(): the largest is that of the shortest direction.
        const float slack =
            kDistanceError * (far + scene_.size) / std::min(std::fabs(along.lo), std::fabs(along.hi));
        float begin = std::max(interval.lo - slack, 0.0F), end = interval.hi + slack;
        for (int axis = 0; axis < 3; ++axis) {
            const bool negative = bundle_.negative[axis];
            const Range& direction = shape.direction[axis];
            const float lo = 1 / (negative ? -direction.lo : direction.hi),
                        hi = 1 / (negative ? -direction.hi : direction.lo), o = bundle_.origin[axis];
            const float in = negative ? o - scene_.hi[axis] : scene_.lo[axis] - o,
                        out = negative ? o - scene_.lo[axis] : scene_.hi[axis] - o;
            begin = std::max(begin, std::min(in * lo, in * hi) * kPlaneDown);
            end = std::min(end, std::max(out * lo, out * hi) * kPlaneUp);
            bundle_.inverseLo[axis][p] = lo;
            bundle_.inverseHi[axis][p] = hi;
        }
        bundle_.begin[p] = begin;
        bundle_.end[p] = end;
        bundle_.reach[p] = std::numeric_limits<float>::infinity();
        bundle_.slack[p] = slack;
        return begin <= end;
    }

    HWY_INLINE void shearRays(BundledPacket& packet) const {
        const FloatTag d;
        const float* const x = rays_.direction[packet.along.kx] + packet.first;
        const float* const y = rays_.direction[packet.along.ky] + packet.first;
        const float* const z = rays_.direction[packet.along.kz] + packet.first;
        for (std::size_t i = 0; i < kGroup; i += kLanes) {
            const Floats along = hn::LoadU(d, z + i);
            hn::Store(hn::Div(hn::LoadU(d, x + i), along), d, packet.sx + i);
            hn::Store(hn::Div(hn::LoadU(d, y + i), along), d, packet.sy + i);
            hn::Store(hn::Div(hn::Set(d, -1.0F), along), d, packet.minusSz + i);
        }
        for (std::size_t b = 0; b < BundledPacket::kBeams; ++b) {
            const std::size_t at = b * BundledPacket::kBeamRays;
            for (const int side : {0, 1}) {
                const Range range =
                    rangeOf<BundledPacket::kBeamRays>((side == 0 ? packet.sx : packet.sy) + at);
                packet.beams[b].shear[side][0] = range.lo - Beam::kWider;
                packet.beams[b].shear[side][1] = range.hi + Beam::kWider;
            }
        }
    }

    const KernelScene& scene_;
    const RaySpan& rays_;
    const Output& output_;
    std::size_t gathered_ = 0;
    bool asBundle_ = true;
    Clock::time_point start_ = Clock::now(); ///< of what is gathered
    Bundle bundle_;
    BundleWalk<kSearch> walk_;
};

/// For any hit: shadow rays have a common end, not a common origin.
struct NoBundles {
    template <typename... Any>
    explicit NoBundles(const Any&...) {}
    template <typename AsPacket>
    HWY_INLINE bool take(const GroupShape&, std::size_t, BundleChoice&, const AsPacket&) const {
        return false;
    }
    HWY_INLINE void finish(BundleChoice&) const {}
};

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
