// The albedo of the GGX lobe, over the number F: float or Float. Included once for each instruction set,
// inside the loop of foreach_target.h, or alone.
#include "rtcore/scattering/ggx_albedo.h"
#include "rtcore/simd/wide-inl.h"

#if defined(RTCORE_SCATTERING_GGX_ALBEDO_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_SCATTERING_GGX_ALBEDO_INL_H_
#undef RTCORE_SCATTERING_GGX_ALBEDO_INL_H_
#else
#define RTCORE_SCATTERING_GGX_ALBEDO_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// Albedo for the reflectance F0: F0 straight + grazing. `mean`: of perfect mirrors, for light from all
/// sides.
template <typename F>
struct GgxAlbedo {
    F straight, grazing, mean;
};

/// `cosine`: of the viewer with the normal; numbers outside 0..1 count as the nearest, NaN as 0.
template <typename F>
HWY_INLINE GgxAlbedo<F> ggxAlbedo(const GgxAlbedoTable& table, F cosine, F roughness) {
    constexpr auto kLast = static_cast<float>(kGgxAlbedoSide - 1);
    // Zero first: so it is NaN that is dropped.
    const F x = min(max(F(0), sqrt(cosine) * kLast), F(kLast));
    const F y = min(max(F(0), roughness * kLast), F(kLast));
    const F column = floor(min(x, F(kLast - 1))), row = floor(min(y, F(kLast - 1)));
    const F right = x - column, down = y - row;
    const IntOf<F> index = truncate(row * static_cast<float>(kGgxAlbedoSide) + column);
    const auto between = [&](const float* corner) HWY_ATTR {
        const F upper = gather(corner, index), upperRight = gather(corner + 1, index);
        const F lower = gather(corner + kGgxAlbedoSide, index);
        const F lowerRight = gather(corner + kGgxAlbedoSide + 1, index);
        const F above = upper + right * (upperRight - upper);
        return above + down * (lower + right * (lowerRight - lower) - above);
    };
    const IntOf<F> line = truncate(row);
    const F mean = gather(table.mean, line);
    return {between(table.straight), between(table.grazing),
            mean + down * (gather(table.mean + 1, line) - mean)};
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
