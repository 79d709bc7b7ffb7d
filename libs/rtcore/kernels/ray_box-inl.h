// Vectors of rays and the root's cell: as single_ray.cpp has it. Included once for each target.
#if defined(RTCORE_KERNELS_RAY_BOX_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_KERNELS_RAY_BOX_INL_H_
#undef RTCORE_KERNELS_RAY_BOX_INL_H_
#else
#define RTCORE_KERNELS_RAY_BOX_INL_H_
#endif

#include "rtcore/kernels/leaf_test-inl.h"
#include "rtcore/kernels/rounding.h"

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

struct RayVector {
    Floats ox, oy, oz, dx, dy, dz, tMin, tMax;
};

/// 1 / direction.
struct InverseVector {
    Floats x, y, z;
};

HWY_INLINE InverseVector inverseOf(const RayVector& ray) {
    const Floats one = hn::Set(FloatTag(), 1.0F);
    return {hn::Div(one, ray.dx), hn::Div(one, ray.dy), hn::Div(one, ray.dz)};
}

struct IntervalVector {
    Floats t0, t1;
};

/// Intervals that end before 0 are empty; they become [infinity, 0], since ends below 0 mean "has been hit"
/// to any-hit walks. None goes beyond the farthest hit.
HWY_INLINE RayVector loadRays(const RaySpan& rays, std::size_t at) {
    const FloatTag d;
    const Floats tMin = hn::LoadU(d, rays.tMin + at);
    const Floats tMax = hn::Min(hn::LoadU(d, rays.tMax + at), hn::Set(d, kFarthestHit));
    const Mask isEmpty = hn::Lt(tMax, hn::Zero(d));
    return {hn::LoadU(d, rays.origin[0] + at),
            hn::LoadU(d, rays.origin[1] + at),
            hn::LoadU(d, rays.origin[2] + at),
            hn::LoadU(d, rays.direction[0] + at),
            hn::LoadU(d, rays.direction[1] + at),
            hn::LoadU(d, rays.direction[2] + at),
            hn::IfThenElse(isEmpty, hn::Set(d, std::numeric_limits<float>::infinity()), tMin),
            hn::IfThenElse(isEmpty, hn::Zero(d), tMax)};
}

/// At least the single ray's slack: by how much the distance of a hit may be off from where the tree says
/// that its cell lies.
HWY_INLINE Floats slackOf(const KernelScene& scene, const RayVector& ray) {
    const FloatTag d;
    const auto farthest = [&](int axis, Floats o) HWY_ATTR {
        return hn::Max(hn::Abs(hn::Sub(hn::Set(d, scene.lo[axis]), o)),
                       hn::Abs(hn::Sub(hn::Set(d, scene.hi[axis]), o)));
    };
    const Floats far = hn::Add(hn::Add(farthest(0, ray.ox), farthest(1, ray.oy)), farthest(2, ray.oz));
    const Floats length = hn::Max(hn::Max(hn::Abs(ray.dx), hn::Abs(ray.dy)), hn::Abs(ray.dz));
    const Floats size = hn::Add(far, hn::Set(d, scene.size));
    return hn::Div(hn::Mul(hn::Set(d, kDistanceError), size), length);
}

/// The part of [tMin - slack, tMax + slack] inside the root's cell, nothing of it behind the origin. 0 *
/// infinity (a ray inside a face, parallel to it) is NaN, which is ignored: such a ray counts as inside.
HWY_INLINE IntervalVector clipToBox(const KernelScene& scene, const RayVector& ray,
                                    const InverseVector& inverse, Floats slack) {
    const FloatTag d;
    IntervalVector interval{hn::Max(hn::Sub(ray.tMin, slack), hn::Zero(d)), hn::Add(ray.tMax, slack)};
    const auto clip = [&](int axis, Floats o, Floats scale) HWY_ATTR {
        const Floats a = hn::Mul(hn::Sub(hn::Set(d, scene.lo[axis]), o), scale);
        const Floats b = hn::Mul(hn::Sub(hn::Set(d, scene.hi[axis]), o), scale);
        const Mask downwards = hn::Lt(scale, hn::Zero(d));
        const Floats enter = hn::IfThenElse(downwards, b, a);
        const Floats leave = hn::IfThenElse(downwards, a, b);
        interval.t0 = max(hn::Mul(enter, hn::Set(d, kPlaneDown)), interval.t0);
        interval.t1 = min(hn::Mul(leave, hn::Set(d, kPlaneUp)), interval.t1);
    };
    clip(0, ray.ox, inverse.x);
    clip(1, ray.oy, inverse.y);
    clip(2, ray.oz, inverse.z);
    return interval;
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
