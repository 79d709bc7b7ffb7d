// Whole waves: groups of 64 rays go as packets where their directions agree, the others as streams. Included
// once for each target.
#if defined(RTCORE_KERNELS_WAVE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_KERNELS_WAVE_INL_H_
#undef RTCORE_KERNELS_WAVE_INL_H_
#else
#define RTCORE_KERNELS_WAVE_INL_H_
#endif

#include "rtcore/kernels/bundle-inl.h"
#include "rtcore/kernels/stream-inl.h"

#include <chrono>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

constexpr std::size_t kGroup = StreamScratch::kGroup;
constexpr std::size_t kGroupVectors = kGroup / kLanes;

/// What the rays of a group have in common.
struct GroupShape {
    Range direction[3];
    Range origin[3]; ///< by addOrigins()

    /// Whether they take much the same way: no component of their directions spans more than three tenths of
    /// the longest (docs/performance.md).
    bool coherent() const {
        constexpr float kSpread = 0.3F;
        float spread = 0;
        float longest = 0;
        for (const Range& r : direction) {
            spread = std::max(spread, r.hi - r.lo);
            longest = std::max(longest, std::max(std::fabs(r.lo), std::fabs(r.hi)));
        }
        return spread < kSpread * longest;
    }
    /// Of no ray the longest component of the direction is shorter.
    float length() const {
        float least = 0;
        for (const Range& r : direction) least = std::max(least, std::max(r.lo, -r.hi));
        return least;
    }
    bool commonOrigin() const {
        return origin[0].lo == origin[0].hi && origin[1].lo == origin[1].hi && origin[2].lo == origin[2].hi;
    }
    /// Whether all directions have one sign on each axis, and no inverse overflows.
    bool oneOctant() const {
        constexpr float kLeast = 1 / std::numeric_limits<float>::max();
        return std::all_of(direction, direction + 3,
                           [](const Range& r) { return r.lo > kLeast || r.hi < -kLeast; });
    }
    Culling culling() const {
        Culling c{};
        for (int axis = 0; axis < 3; ++axis) {
            c.origin[axis] = origin[axis];
            c.inverse[axis] = {1 / direction[axis].hi, 1 / direction[axis].lo};
            const Range& r = c.inverse[axis];
            constexpr float kLargest = std::numeric_limits<float>::max();
            c.uniform[axis] =
                (direction[axis].lo > 0 && r.hi <= kLargest) || (direction[axis].hi < 0 && r.lo >= -kLargest);
            c.upperFirst[axis] = direction[axis].hi < 0 ? 1 : 0;
        }
        return c;
    }
};

/// Of kCount values.
template <std::size_t kCount>
HWY_INLINE Range rangeOf(const float* values) {
    const FloatTag d;
    Floats lo = hn::LoadU(d, values);
    Floats hi = lo;
    for (std::size_t i = kLanes; i < kCount; i += kLanes) {
        const Floats v = hn::LoadU(d, values + i);
        lo = hn::Min(lo, v);
        hi = hn::Max(hi, v);
    }
    return {hn::GetLane(hn::MinOfLanes(d, lo)), hn::GetLane(hn::MaxOfLanes(d, hi))};
}

HWY_INLINE GroupShape shapeOf(const RaySpan& rays, std::size_t first) {
    GroupShape shape;
    for (int axis = 0; axis < 3; ++axis)
        shape.direction[axis] = rangeOf<kGroup>(rays.direction[axis] + first);
    return shape;
}

HWY_INLINE bool haveCommonOrigin(const RaySpan& rays, std::size_t first) {
    const FloatTag d;
    Mask other = hn::FirstN(d, 0);
    for (const float* const all : rays.origin) {
        const Floats one = hn::Set(d, all[first]);
        for (std::size_t i = first; i < first + kGroup; i += kLanes)
            other = hn::Or(other, hn::Ne(hn::LoadU(d, all + i), one));
    }
    return hn::AllFalse(d, other);
}

HWY_INLINE void addOrigins(const RaySpan& rays, std::size_t first, GroupShape& shape) {
    for (int axis = 0; axis < 3; ++axis) shape.origin[axis] = rangeOf<kGroup>(rays.origin[axis] + first);
}

/// 0, 1, 2 where that is the dominant axis of all; else 3.
HWY_INLINE int commonAxis(const GroupShape& shape, const RaySpan& rays, std::size_t first) {
    const auto least = [&](int axis) {
        return std::max(shape.direction[axis].lo, -shape.direction[axis].hi);
    };
    const auto most = [&](int axis) { return std::max(-shape.direction[axis].lo, shape.direction[axis].hi); };
    for (int axis = 0; axis < 3; ++axis) {
        if (least(axis) > most((axis + 1) % 3) && least(axis) > most((axis + 2) % 3)) return axis;
    }
    const FloatTag d;
    Mask allX = hn::Eq(hn::Zero(d), hn::Zero(d));
    Mask allY = allX;
    Mask anyXY = hn::FirstN(d, 0);
    for (std::size_t i = first; i < first + kGroup; i += kLanes) {
        const AxisOrder order(hn::LoadU(d, rays.direction[0] + i), hn::LoadU(d, rays.direction[1] + i),
                              hn::LoadU(d, rays.direction[2] + i));
        allX = hn::And(allX, order.isX);
        allY = hn::And(allY, order.isY);
        anyXY = hn::Or(anyXY, hn::Or(order.isX, order.isY));
    }
    if (hn::AllTrue(d, allX)) return 0;
    if (hn::AllTrue(d, allY)) return 1;
    return hn::AllFalse(d, anyXY) ? 2 : 3;
}

/// At least slackOf() of each ray: of all origins the farthest, of all directions the shortest.
HWY_INLINE float slackOf(const KernelScene& scene, const GroupShape& shape) {
    float far = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const Range& o = shape.origin[axis];
        far += std::max(std::max(std::fabs(scene.lo[axis] - o.lo), std::fabs(scene.lo[axis] - o.hi)),
                        std::max(std::fabs(scene.hi[axis] - o.lo), std::fabs(scene.hi[axis] - o.hi)));
    }
    return kDistanceError * far / shape.length();
}

/// The same of a group whose directions may have nothing in common.
HWY_NOINLINE float slackOfEach(const KernelScene& scene, const RaySpan& rays, std::size_t first) {
    const FloatTag d;
    Floats slack = hn::Zero(d);
    for (std::size_t i = 0; i < kGroup; i += kLanes)
        slack = hn::Max(slack, slackOf(scene, loadRays(rays, first + i)));
    return hn::GetLane(hn::MaxOfLanes(d, slack));
}

/// The rays of a group as a packet; those from `count` on take no part. False where none meets the root's
/// cell.
template <bool kAny>
HWY_INLINE bool load(const KernelScene& scene, const RaySpan& rays, const GroupShape& shape,
                     std::size_t first, std::size_t count, Packet<kGroupVectors>& packet) {
    const FloatTag d;
    const IntTag di;
    packet.slack = shape.length() > 0 ? slackOf(scene, shape) : slackOfEach(scene, rays, first);
    const Floats slack = hn::Set(d, packet.slack);
    Mask enters = hn::FirstN(d, 0);
    for (std::size_t i = 0; i < kGroup; i += kLanes) {
        const RayVector ray = loadRays(rays, first + i);
        const InverseVector inverse = inverseOf(ray);
        const IntervalVector inside = clipToBox(scene, ray, inverse, slack);
        enters = hn::Or(enters, hn::Le(inside.t0, inside.t1));
        hn::Store(inside.t0, d, packet.t0 + i);
        hn::Store(inside.t1, d, packet.t1 + i);
        hn::Store(ray.ox, d, packet.origin[0] + i);
        hn::Store(ray.oy, d, packet.origin[1] + i);
        hn::Store(ray.oz, d, packet.origin[2] + i);
        hn::Store(ray.dx, d, packet.direction[0] + i);
        hn::Store(ray.dy, d, packet.direction[1] + i);
        hn::Store(ray.dz, d, packet.direction[2] + i);
        hn::Store(inverse.x, d, packet.inverse[0] + i);
        hn::Store(inverse.y, d, packet.inverse[1] + i);
        hn::Store(inverse.z, d, packet.inverse[2] + i);
        hn::Store(ray.tMin, d, packet.tMin + i);
        hn::Store(ray.tMax, d, packet.best + i);
        hn::Store(hn::Set(di, kNone), di, packet.triangle + i);
        if constexpr (kAny) continue;
        hn::Store(hn::Zero(d), d, packet.v + i);
        hn::Store(hn::Zero(d), d, packet.w + i);
        hn::Store(hn::Set(d, 1.0F), d, packet.det + i);
    }
    packet.startTriangle = startsAt(rays.startTriangle, first);
    for (std::size_t i = count; i < kGroup; ++i) {
        packet.t0[i] = 1;
        packet.t1[i] = -1;
        packet.best[i] = -1;
    }
    return !hn::AllFalse(d, enters);
}

/// For any hit, whether to begin at the far end of rays: shadow rays may be stopped near the light, by a
/// roof, or near where they start. What packets took by each order tells which is better for those that
/// follow.
class OrderChoice {
  public:
    /// For the next packet.
    HWY_INLINE bool farFirst() {
        constexpr std::uint32_t kTrial = 32;
        const bool better = mean_[1] < mean_[0];
        tried_ = count_ < 2 ? count_ == 1 : count_ % kTrial == 0 ? !better : better;
        ++count_;
        return tried_;
    }
    /// It took so much.
    HWY_INLINE void learn(std::uint32_t cost) {
        constexpr float kNew = 1.0F / 16;
        float& mean = mean_[tried_ ? 1 : 0];
        mean = count_ <= 2 ? static_cast<float>(cost) : mean + (static_cast<float>(cost) - mean) * kNew;
    }

  private:
    float mean_[2] = {};
    std::uint32_t count_ = 0;
    bool tried_ = false;
};

template <Search kSearch>
class PacketTracer {
  public:
    PacketTracer(const KernelScene& scene, const RaySpan& rays)
        : scene_(scene), rays_(rays), byOrigin_(scene, packet), byAxis_(scene, packet),
          byNothing_(scene, packet) {}

    /// Traces `count` rays from `first` on; `packet` then holds what they found. All kGroup must be readable.
    HWY_INLINE void trace(GroupShape shape, std::size_t first, std::size_t count) {
        addOrigins(rays_, first, shape);
        if (!load<kSearch.any>(scene_, rays_, shape, first, count, packet)) return;
        const Culling culling = shape.culling();
        const int axis = commonAxis(shape, rays_, first);
        if (axis == 3) {
            runWalk(byNothing_, culling);
        } else if (shape.commonOrigin()) {
            byOrigin_.setAxis(axis);
            byOrigin_.setPoint(packet.at(0, 0));
            runWalk(byOrigin_, culling);
        } else {
            byAxis_.setAxis(axis);
            byAxis_.setPoint(meetingPoint());
            runWalk(byAxis_, culling);
        }
    }

    Packet<kGroupVectors> packet;

  private:
    /// Shadow rays of a point light end there; others may at least begin near each other.
    HWY_INLINE Vec3 meetingPoint() const {
        constexpr float kNear = 4; // of the scene's sides; what is far away says little about small things
        if constexpr (kSearch.any) {
            const Vec3 end = packet.at(0, packet.best[0]);
            bool near = true;
            for (int axis = 0; axis < 3; ++axis) {
                const float side = scene_.hi[axis] - scene_.lo[axis];
                near = near && end[axis] > scene_.lo[axis] - kNear * side &&
                       end[axis] < scene_.hi[axis] + kNear * side;
            }
            if (near) return end;
        }
        return packet.at(0, 0);
    }

    template <typename Walk>
    HWY_INLINE void runWalk(Walk& walk, const Culling& culling) {
        if constexpr (!kSearch.any) {
            walk.run(0, culling);
            return;
        }
        walk.occluder = occluder_;
        walk.farFirst = order_.farFirst();
        walk.cost = 0;
        walk.run(0, culling);
        order_.learn(walk.cost);
        occluder_ = walk.occluder;
    }

    const KernelScene& scene_;
    const RaySpan& rays_;
    Corners occluder_;
    OrderChoice order_;
    PacketWalk<kGroupVectors, Shared::Origin, true, kSearch> byOrigin_;
    PacketWalk<kGroupVectors, Shared::Axis, true, kSearch> byAxis_;
    PacketWalk<kGroupVectors, Shared::Nothing, true, kSearch> byNothing_;
};

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
        const IntTag di;
        BundledPacket& packet = bundle_.packets[bundle_.size];
        packet.first = first;
        packet.startTriangle = startsAt(rays_.startTriangle, first);
        packet.along = along;
        Floats nearest = hn::Set(d, std::numeric_limits<float>::infinity()), farthest = hn::Zero(d);
        for (std::size_t i = 0; i < kGroup; i += kLanes) {
            const RayVector ray = loadRays(rays_, first + i);
            nearest = hn::Min(nearest, ray.tMin);
            farthest = hn::Max(farthest, ray.tMax);
            hn::Store(ray.tMin, d, packet.tMin + i);
            hn::Store(ray.tMax, d, packet.best + i);
            hn::Store(hn::Set(di, kNone), di, packet.triangle + i);
            hn::Store(hn::Zero(d), d, packet.v + i);
            hn::Store(hn::Zero(d), d, packet.w + i);
            hn::Store(hn::Set(d, 1.0F), d, packet.det + i);
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
        const float slack = kDistanceError * far / std::min(std::fabs(along.lo), std::fabs(along.hi));
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

/// The last rays of a wave, filled up to a whole group by the first of them.
struct LastGroup {
    LastGroup(const RaySpan& rays, std::size_t first) {
        const float* from[8] = {rays.origin[0],    rays.origin[1],    rays.origin[2], rays.direction[0],
                                rays.direction[1], rays.direction[2], rays.tMin,      rays.tMax};
        for (std::size_t c = 0; c < 8; ++c) {
            for (std::size_t i = 0; i < kGroup; ++i) {
                values[c][i] = from[c][first + i < rays.count ? first + i : first];
            }
        }
        span = {{values[0], values[1], values[2]},
                {values[3], values[4], values[5]},
                values[6],
                values[7],
                kGroup,
                rays.startTriangle == nullptr ? nullptr : startTriangle};
        if (rays.startTriangle == nullptr) return;
        for (std::size_t i = 0; i < kGroup; ++i)
            startTriangle[i] = rays.startTriangle[first + i < rays.count ? first + i : first];
    }
    alignas(64) float values[8][kGroup];
    std::uint32_t startTriangle[kGroup];
    RaySpan span;
};

/// `Output` stores what a packet or a stream's slots hold.
template <Search kSearch, typename Output>
HWY_INLINE void traverseWave(const KernelScene& scene, const RaySpan& rays, StreamScratch& scratch,
                             Output&& output) {
    constexpr std::size_t kFewest = 512 / kGroup; // below, packets are faster whatever the directions
    PacketTracer<kSearch> packets(scene, rays);
    std::conditional_t<kSearch.any, NoBundles, BundleTracer<kSearch, std::remove_reference_t<Output>>>
        bundles(scene, rays, output);
    const auto asPacket = [&](const GroupShape& shape, std::size_t first) HWY_ATTR {
        packets.trace(shape, first, kGroup);
        output.fromPacket(packets.packet, first, kGroup);
    };
    const auto asStream = [&]() HWY_ATTR {
        StreamWalk<kSearch> stream(scene, scratch);
        stream.run(rays);
        for (std::size_t g = 0; g < scratch.groupCount; ++g) output.fromSlots(scratch, g);
        scratch.groupCount = 0;
    };
    scratch.groupCount = 0;
    const std::size_t whole = rays.count / kGroup * kGroup;
    for (std::size_t first = 0; first < whole; first += kGroup) {
        const GroupShape shape = shapeOf(rays, first);
        if (shape.coherent()) {
            if (!bundles.take(shape, first, scratch.bundleChoice, asPacket)) asPacket(shape, first);
            continue;
        }
        scratch.groups[scratch.groupCount++] = static_cast<std::uint32_t>(first);
        if (scratch.groupCount == StreamScratch::kRays / kGroup) asStream();
    }
    bundles.finish(scratch.bundleChoice);
    if (scratch.groupCount >= kFewest) {
        asStream();
    } else {
        for (std::size_t g = 0; g < scratch.groupCount; ++g)
            asPacket(shapeOf(rays, scratch.groups[g]), scratch.groups[g]);
    }
    if (whole == rays.count) return;
    const LastGroup last(rays, whole);
    PacketTracer<kSearch> tracer(scene, last.span);
    tracer.trace(shapeOf(last.span, 0), 0, rays.count - whole);
    output.fromPacket(tracer.packet, whole, rays.count - whole);
}

struct ClosestOutput {
    const HitSpan& hits;

    template <typename P>
    HWY_INLINE void fromPacket(const P& p, std::size_t first, std::size_t count) const {
        store(p.best, p.triangle, p.v, p.w, p.det, first, count);
    }
    HWY_INLINE void fromSlots(const StreamScratch& s, std::size_t group) const {
        const std::size_t at = group * kGroup;
        store(s.best + at, s.triangle + at, s.v + at, s.w + at, s.det + at, s.groups[group], kGroup);
    }

  private:
    HWY_INLINE void store(const float* best, const std::int32_t* triangle, const float* v, const float* w,
                          const float* det, std::size_t first, std::size_t count) const {
        const FloatTag d;
        const IntTag di;
        for (std::size_t i = 0; i < count; i += kLanes) {
            const Floats area = hn::Load(d, det + i);
            const Ints known = hn::Load(di, triangle + i);
            const Ints index = hn::IfThenElse(hn::Eq(known, hn::Set(di, kNone)), hn::Set(di, -1), known);
            const Floats share1 = hn::Div(hn::Load(d, v + i), area);
            const Floats share2 = hn::Div(hn::Load(d, w + i), area);
            const Floats t = hn::Load(d, best + i);
            const auto out = reinterpret_cast<std::int32_t*>(hits.triangle + first + i);
            if (i + kLanes <= count) {
                hn::StoreU(t, d, hits.t + first + i);
                hn::StoreU(share1, d, hits.u + first + i);
                hn::StoreU(share2, d, hits.v + first + i);
                hn::StoreU(index, di, out);
            } else {
                const Mask some = hn::FirstN(d, count - i);
                hn::BlendedStore(t, some, d, hits.t + first + i);
                hn::BlendedStore(share1, some, d, hits.u + first + i);
                hn::BlendedStore(share2, some, d, hits.v + first + i);
                hn::BlendedStore(index, hn::RebindMask(di, some), di, out);
            }
        }
    }
};

struct AnyOutput {
    std::uint8_t* occluded;

    HWY_INLINE void fromPacket(const Packet<kGroupVectors>& p, std::size_t first, std::size_t count) const {
        if (HWY_LIKELY(count == kGroup)) {
            store(p.best, p.triangle, occluded + first);
            return;
        }
        std::uint8_t all[kGroup];
        store(p.best, p.triangle, all);
        std::copy_n(all, count, occluded + first);
    }
    HWY_INLINE void fromSlots(const StreamScratch& s, std::size_t group) const {
        const std::size_t slot = group * kGroup;
        store(s.best + slot, s.triangle + slot, occluded + s.groups[group]);
    }

  private:
    /// Of a group: 1 for rays that were stopped, 2 for those that passed through something.
    static HWY_INLINE void store(const float* best, const std::int32_t* triangle, std::uint8_t* to) {
        const FloatTag d;
        const IntTag di;
        const hn::Rebind<std::uint8_t, IntTag> d8;
        for (std::size_t i = 0; i < kGroup; i += kLanes) {
            const Mask stopped = hn::Lt(hn::Load(d, best + i), hn::Zero(d));
            const auto passed = hn::Ne(hn::Load(di, triangle + i), hn::Set(di, kNone));
            const Ints found = hn::IfThenElse(hn::RebindMask(di, stopped), hn::Set(di, 1),
                                              hn::IfThenElseZero(passed, hn::Set(di, 2)));
            hn::StoreU(hn::DemoteTo(d8, found), d8, to + i);
        }
    }
};

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
