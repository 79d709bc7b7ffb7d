// Common properties of the 64 rays of a group. Included once for each target.
#if defined(RTCORE_KERNELS_GROUP_SHAPE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_KERNELS_GROUP_SHAPE_INL_H_
#undef RTCORE_KERNELS_GROUP_SHAPE_INL_H_
#else
#define RTCORE_KERNELS_GROUP_SHAPE_INL_H_
#endif

#include "rtcore/kernels/packet-inl.h"
#include "rtcore/kernels/ray_box-inl.h"
#include "rtcore/kernels/stream_scratch.h"

#include <algorithm>
#include <cmath>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

constexpr std::size_t kGroup = StreamScratch::kGroup;
constexpr std::size_t kGroupVectors = kGroup / kLanes;

/// Common properties of the rays of a group.
struct GroupShape {
    Range direction[3];
    Range origin[3]; ///< by addOrigins()

    /// Whether they take much the same way: no component of their directions spans more than three tenths of
    /// the longest (docs/lab/kernels.md).
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
    /// A lower bound of the longest component of each ray's direction.
    float length() const {
        float min = 0;
        for (const Range& r : direction) min = std::max(min, std::max(r.lo, -r.hi));
        return min;
    }
    bool commonOrigin() const {
        return origin[0].lo == origin[0].hi && origin[1].lo == origin[1].hi && origin[2].lo == origin[2].hi;
    }
    /// Whether all directions have one sign on each axis, and no inverse overflows.
    bool oneOctant() const {
        constexpr float kMin = 1 / std::numeric_limits<float>::max();
        return std::all_of(direction, direction + 3,
                           [](const Range& r) { return r.lo > kMin || r.hi < -kMin; });
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

/// Range of kCount values.
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
    const auto minOf = [&](int axis) {
        return std::max(shape.direction[axis].lo, -shape.direction[axis].hi);
    };
    const auto maxOf = [&](int axis) {
        return std::max(-shape.direction[axis].lo, shape.direction[axis].hi);
    };
    for (int axis = 0; axis < 3; ++axis) {
        if (minOf(axis) > maxOf((axis + 1) % 3) && minOf(axis) > maxOf((axis + 2) % 3)) return axis;
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
    return kDistanceError * (far + scene.size) / shape.length();
}

/// The same of a group whose directions may have nothing in common.
HWY_NOINLINE float slackOfEach(const KernelScene& scene, const RaySpan& rays, std::size_t first) {
    const FloatTag d;
    Floats slack = hn::Zero(d);
    for (std::size_t i = 0; i < kGroup; i += kLanes)
        slack = hn::Max(slack, slackOf(scene, loadRays(rays, first + i)));
    return hn::GetLane(hn::MaxOfLanes(d, slack));
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
