#include "rtcore/kernels/clip_rays.h"

#include <cstddef>

// Compiled once for each instruction set, and the best chosen when the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/kernels/clip_rays.cpp"
#include "rtcore/simd/foreach_target.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;

HWY_INLINE hn::Vec<Floats> along(const Vec3& n, const float* const axes[3], std::size_t i) {
    const Floats d;
    const auto x = hn::Mul(hn::Set(d, n.x), hn::LoadU(d, axes[0] + i));
    const auto y = hn::Mul(hn::Set(d, n.y), hn::LoadU(d, axes[1] + i));
    const auto z = hn::Mul(hn::Set(d, n.z), hn::LoadU(d, axes[2] + i));
    return hn::Add(hn::Add(x, y), z);
}

HWY_INLINE float alongOne(const Vec3& n, const float* const axes[3], std::size_t i) {
    return n.x * axes[0][i] + n.y * axes[1][i] + n.z * axes[2][i];
}

/// As clipInterval().
void clip(const HalfSpace& half, const RaySpan& rays, float* tMin, float* tMax) {
    const Floats d;
    const std::size_t lanes = hn::Lanes(d);
    const auto zero = hn::Zero(d);
    std::size_t i = 0;
    for (; i + lanes <= rays.count; i += lanes) {
        const auto speed = along(half.normal, rays.direction, i);
        const auto room = hn::Sub(hn::Set(d, half.offset), along(half.normal, rays.origin, i));
        const auto t = hn::Div(room, speed), first = hn::LoadU(d, rays.tMin + i),
                   last = hn::LoadU(d, rays.tMax + i);
        const auto towards = hn::Gt(speed, zero), away = hn::Lt(speed, zero);
        const auto earlier = hn::And(towards, hn::Lt(t, last)), later = hn::And(away, hn::Lt(first, t));
        const auto beside = hn::AndNot(hn::Or(towards, away), hn::Lt(room, zero));
        hn::StoreU(hn::IfThenElse(later, t, first), d, tMin + i);
        const auto end = hn::IfThenElse(earlier, t, last);
        hn::StoreU(hn::IfThenElse(beside, hn::Set(d, -1.0F), end), d, tMax + i);
    }
    for (; i < rays.count; ++i) {
        const float room = half.offset - alongOne(half.normal, rays.origin, i);
        tMin[i] = rays.tMin[i];
        tMax[i] = rays.tMax[i];
        clipInterval(alongOne(half.normal, rays.direction, i), room, tMin[i], tMax[i]);
    }
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(clip);

RaySpan clipRays(std::span<const HalfSpace> halves, RaySpan rays, float* tMin, float* tMax) {
    for (const HalfSpace& half : halves) {
        HWY_DYNAMIC_DISPATCH(clip)(half, rays, tMin, tMax);
        rays.tMin = tMin;
        rays.tMax = tMax;
    }
    return rays;
}

} // namespace rtcore
#endif
