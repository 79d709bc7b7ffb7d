// Path::length, over the number F: float or Float. Included once for each instruction set, inside the loop of
// foreach_target.h, or alone.
#include "rtcore/math/float3-inl.h"

#if defined(RTCORE_SHADING_PATHS_PATH_LENGTH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_SHADING_PATHS_PATH_LENGTH_INL_H_
#undef RTCORE_SHADING_PATHS_PATH_LENGTH_INL_H_
#else
#define RTCORE_SHADING_PATHS_PATH_LENGTH_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// Whether what mirrors or refracts there does it as a plane does.
template <typename F>
HWY_INLINE auto isFlat(Vec3Of<F> shadingNormal, Vec3Of<F> geometricNormal) {
    constexpr float kMax = 1e-6F;
    const Vec3Of<F> off = shadingNormal - geometricNormal;
    return dot(off, off) < kMax;
}

/// That of a ray that begins `t` further on; `straight`: it is not bent there by anything curved.
template <typename F, typename Where>
HWY_INLINE F lengthAfter(F length, F t, Where straight) {
    const F whole = length + t;
    return select(length < 0.0F, length, select(straight, whole, -whole));
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
