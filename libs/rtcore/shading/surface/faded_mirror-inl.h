// Mirrors in place of lobes, over the number F: float or Float. Included once for each instruction set,
// inside the loop of foreach_target.h, or alone.
#include "rtcore/scattering/ggx.h"
#include "rtcore/scene/metallic_roughness.h"
#include "rtcore/simd/wide-inl.h"

#if defined(RTCORE_SHADING_SURFACE_FADED_MIRROR_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_SHADING_SURFACE_FADED_MIRROR_INL_H_
#undef RTCORE_SHADING_SURFACE_FADED_MIRROR_INL_H_
#else
#define RTCORE_SHADING_SURFACE_FADED_MIRROR_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// The share of the gloss of a smooth surface that Whitted's ray tracing shows by one mirrored ray: all of it
/// where it is a mirror, nothing from kMirrorsBelow on.
template <typename F>
HWY_INLINE F fadedMirror(F roughness) {
    constexpr float kNarrow = 0.0316F; // its square is kMinAlpha
    const F faded = clamp<F>((kMirrorsBelow - roughness) / (kMirrorsBelow - kNarrow), 0.0F, 1.0F);
    return select(roughness * roughness < kMinAlpha, F(1), faded);
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
