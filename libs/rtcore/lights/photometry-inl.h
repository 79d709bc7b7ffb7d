// The distribution of a luminaire's light, over the number F: float or Float. Included once for each
// instruction set, inside the loop of foreach_target.h, or alone.
#include "rtcore/math/float3-inl.h"
#include "rtcore/scene/photometry.h"
#include "rtcore/simd/functions-inl.h"

#if defined(RTCORE_LIGHTS_PHOTOMETRY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_LIGHTS_PHOTOMETRY_INL_H_
#undef RTCORE_LIGHTS_PHOTOMETRY_INL_H_
#else
#define RTCORE_LIGHTS_PHOTOMETRY_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// Two knots that are neighbours.
template <typename F>
struct KnotPair {
    IntOf<F> first;
    F fraction; ///< of the second, 0..1
};
/// Of `count` ascending knots, two or more, those around x, or the outermost ones.
template <typename F>
HWY_INLINE KnotPair<F> knotsAround(const float* knots, std::uint32_t count, F x) {
    IntOf<F> first = truncate(F(0));
    for (std::uint32_t pairs = count - 1; pairs > 1;) {
        const std::uint32_t half = pairs / 2;
        const IntOf<F> next = first + static_cast<std::int32_t>(half);
        first = select(gather(knots, next) <= x, next, first);
        pairs -= half;
    }
    const F low = gather(knots, first), high = gather(knots, first + 1);
    return {first, clamp<F>((x - low) / (high - low), 0.0F, 1.0F)};
}

/// The relative intensity in a direction, bilinear in gamma and C; 0 beyond the gammas. Of the direction the
/// components along the axis, where C = 0 points and where C = 90 degrees does; of any length.
template <typename F>
HWY_INLINE F measuredFactor(const Photometry& web, F ahead, F right, F across) {
    const F gamma = fastAtan2<F>(sqrt(right * right + across * across), ahead);
    const KnotPair<F> row = knotsAround<F>(web.gammas, web.gammaCount, gamma);
    const auto along = [&](IntOf<F> at) {
        const F low = gather(web.relative, at), high = gather(web.relative, at + 1);
        return low + (high - low) * row.fraction;
    };
    const auto within = (gamma >= web.gammas[0]) & (gamma <= web.gammas[web.gammaCount - 1]);
    if (!web.turned) return selectOrZero(within, along(row.first));
    const F angle = fastAtan2<F>(across, right);
    const F turn = select(angle < web.planes[0], angle + 6.28318531F, angle);
    const KnotPair<F> plane = knotsAround<F>(web.planes, web.planeCount, turn);
    const auto count = static_cast<std::int32_t>(web.gammaCount);
    const IntOf<F> at = plane.first * count + row.first;
    const F first = along(at), second = along(at + count);
    return selectOrZero(within, first + (second - first) * plane.fraction);
}
/// `away`: from the luminaire.
template <typename F>
HWY_INLINE F measuredFactor(const Light& light, Vec3Of<F> away) {
    return measuredFactor<F>(photometryOf(light), dot(away, broadcast<F>(light.direction)),
                             dot(away, broadcast<F>(light.right)),
                             dot(away, broadcast<F>(cross(light.right, light.direction))));
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
