// Groups of rays that go as packets. Included once for each target.
#if defined(RTCORE_KERNELS_PACKET_TRACER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_KERNELS_PACKET_TRACER_INL_H_
#undef RTCORE_KERNELS_PACKET_TRACER_INL_H_
#else
#define RTCORE_KERNELS_PACKET_TRACER_INL_H_
#endif

#include "rtcore/kernels/group_shape-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// Stores the intervals in which a vector of rays searches, and that it has found nothing yet.
template <bool kAny, typename AnyPacket>
HWY_INLINE void beginSearch(const RayVector& ray, AnyPacket& packet, std::size_t at) {
    const FloatTag d;
    hn::Store(ray.tMin, d, packet.tMin + at);
    hn::Store(ray.tMax, d, packet.best + at);
    hn::Store(hn::Set(IntTag(), kNone), IntTag(), packet.triangle + at);
    if constexpr (kAny) return;
    hn::Store(hn::Zero(d), d, packet.v + at);
    hn::Store(hn::Zero(d), d, packet.w + at);
    hn::Store(hn::Set(d, 1.0F), d, packet.det + at);
}

/// The rays of a group as a packet; those from `count` on take no part. False where none meets the root's
/// cell.
template <bool kAny>
HWY_INLINE bool load(const KernelScene& scene, const RaySpan& rays, const GroupShape& shape,
                     std::size_t first, std::size_t count, Packet<kGroupVectors>& packet) {
    const FloatTag d;
    packet.setSlack(shape.length() > 0 ? slackOf(scene, shape) : slackOfEach(scene, rays, first));
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
        beginSearch<kAny>(ray, packet, i);
    }
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
            byOrigin_.leaves.setAxis(axis);
            byOrigin_.leaves.setPoint(packet.at(0, 0));
            runWalk(byOrigin_, culling);
        } else {
            byAxis_.leaves.setAxis(axis);
            byAxis_.leaves.setPoint(meetingPoint());
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
        walk.leaves.occluder = occluder_;
        walk.farFirst = order_.farFirst();
        walk.cost = 0;
        walk.run(0, culling);
        order_.learn(walk.cost);
        occluder_ = walk.leaves.occluder;
    }

    const KernelScene& scene_;
    const RaySpan& rays_;
    Corners occluder_;
    OrderChoice order_;
    PacketWalk<kGroupVectors, Shared::Origin, true, kSearch> byOrigin_;
    PacketWalk<kGroupVectors, Shared::Axis, true, kSearch> byAxis_;
    PacketWalk<kGroupVectors, Shared::Nothing, true, kSearch> byNothing_;
};

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
