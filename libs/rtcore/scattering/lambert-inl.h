// Matte surfaces, over the number F: float or Float. Included once for each instruction set, inside the loop
// of foreach_target.h, or alone.
#include "rtcore/math/constants.h"
#include "rtcore/math/float3-inl.h"
#include "rtcore/sampling/disc-inl.h"
#include "rtcore/sampling/owen-inl.h"

#if defined(RTCORE_SCATTERING_LAMBERT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_SCATTERING_LAMBERT_INL_H_
#undef RTCORE_SCATTERING_LAMBERT_INL_H_
#else
#define RTCORE_SCATTERING_LAMBERT_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// The response of several lobes together to light from a direction; all 0 below the surface.
template <typename F>
struct Scattering {
    Vec3Of<F> reflectance; ///< f_r, without the cosine
    F density;             ///< by solid angle, of sampling the direction
};

/// f_r of an albedo of 1.
inline constexpr float kLambertLobe = 1 / kPi;

/// Density of sampleLambert() by solid angle. `cosine`: that of the direction with the normal.
template <typename F>
HWY_INLINE F lambertDensity(F cosine) {
    return max(cosine, F(0)) * kLambertLobe;
}

/// A direction of unit length, above the surface, by Malley's method.
template <typename F>
HWY_INLINE Vec3Of<F> sampleLambert(Vec3Of<F> normal, SquarePointOf<F> point) {
    const auto disc = onDisc<F>(point.u, point.v);
    constexpr float kMinSquaredCosine = 1e-12F;
    const F height = sqrt(max(1.0F - disc.x * disc.x - disc.y * disc.y, F(kMinSquaredCosine)));
    const auto basis = basisAround(normal);
    return basis.tangent * disc.x + basis.bitangent * disc.y + normal * height;
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
