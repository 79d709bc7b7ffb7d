// Directions as points of a square: the sphere unfolded by way of an octahedron (Praun and Hoppe 2003), over
// the number F: float or Float. Its poles lie on the y axis, the upper half of the sphere in the square's
// middle. Included once for each instruction set, inside the loop of foreach_target.h, or alone.
#include "rtcore/math/float3-inl.h"
#include "rtcore/simd/functions-inl.h"

#if defined(RTCORE_MATH_OCTAHEDRON_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_MATH_OCTAHEDRON_INL_H_
#undef RTCORE_MATH_OCTAHEDRON_INL_H_
#else
#define RTCORE_MATH_OCTAHEDRON_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

template <typename F>
struct OctahedronPoint {
    F x, y; ///< 0..1; NaN of the direction (0, 0, 0)
};

/// The point of a direction of any length.
template <typename F>
HWY_INLINE OctahedronPoint<F> octahedronPoint(Vec3Of<F> direction) {
    const F sum = abs(direction.x) + abs(direction.y) + abs(direction.z);
    const F u = direction.x / sum, v = direction.z / sum;
    const auto below = direction.y < 0.0F;
    const F x = select(below, copySign(1.0F - abs(v), u), u);
    const F y = select(below, copySign(1.0F - abs(u), v), v);
    return {x * 0.5F + 0.5F, y * 0.5F + 0.5F};
}

/// The way back; F may be double, too. The direction ends on the octahedron: its components' sizes sum to 1.
template <typename F>
HWY_INLINE Vec3Of<F> octahedronDirection(F x, F y) {
    const F u = x * F(2) - F(1), v = y * F(2) - F(1);
    const F height = F(1) - abs(u) - abs(v);
    const auto below = height < F(0);
    return {select(below, copySign(F(1) - abs(v), u), u), height,
            select(below, copySign(F(1) - abs(u), v), v)};
}

/// The texel of an image of side x side that the direction falls into, row by row; one of them, whatever the
/// direction.
template <typename F>
HWY_INLINE IntOf<F> octahedronTexel(Vec3Of<F> direction, int side) {
    const OctahedronPoint<F> p = octahedronPoint<F>(direction);
    const auto scale = static_cast<float>(side), last = static_cast<float>(side - 1);
    // Zero first: so it is NaN that is dropped.
    const F column = floor(min(max(F(0), p.x * scale), F(last)));
    const F row = floor(min(max(F(0), p.y * scale), F(last)));
    return truncate(row * scale + column);
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
