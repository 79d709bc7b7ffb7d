// Directions of a panorama, over the number F: float or Float. Included once for each instruction set, inside
// the loop of foreach_target.h.
#include "rtcore/math/float3-inl.h"
#include "rtcore/render/camera_rays.h"
#include "rtcore/simd/functions-inl.h"

#if defined(RTCORE_RENDER_PANORAMA_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_RENDER_PANORAMA_INL_H_
#undef RTCORE_RENDER_PANORAMA_INL_H_
#else
#define RTCORE_RENDER_PANORAMA_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// Of the point (x, y) of the image, in pixels from its upper left corner: error below 1e-6.
HWY_INLINE Float3 directionAround(const CameraRays::Around& around, Float x, Float y) {
    // Half the angle, which fastCircle() takes, and twice that.
    const auto half = fastCircle(Float(x * around.column * 0.5F - 1.57079632679F));
    const Float ahead = (half.cosine - half.sine) * (half.cosine + half.sine);
    const Float aside = 2.0F * half.sine * half.cosine;
    const auto below = fastCircle(Float(y * around.row - 1.57079632679F));
    return broadcast(around.forward) * (below.cosine * ahead) +
           broadcast(around.right) * (below.cosine * aside) + broadcast(around.down) * below.sine;
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
