// Directions drawn from a table of cells of the sphere, over the number F: float or Float. Included once for
// each instruction set, inside the loop of foreach_target.h, or alone.
#include "rtcore/lights/environment_draw.h"
#include "rtcore/math/octahedron-inl.h"
#include "rtcore/sampling/alias-inl.h"

#if defined(RTCORE_LIGHTS_ENVIRONMENT_DRAW_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_LIGHTS_ENVIRONMENT_DRAW_INL_H_
#undef RTCORE_LIGHTS_ENVIRONMENT_DRAW_INL_H_
#else
#define RTCORE_LIGHTS_ENVIRONMENT_DRAW_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

template <typename F>
struct DirectionDraw {
    Vec3Of<F> direction; ///< unit
    F density;           ///< by solid angle
};

/// Solid angle over area of the unfolded square, 0..1 each way, at a unit vector. (With the sum s of the
/// sizes of its components it is d = s p, p on the octahedron; a face lies 1 / sqrt(3) away, and its area is
/// sqrt(3) times that of the square of side 2 that it unfolds to.)
template <typename F>
HWY_INLINE F octahedronScale(Vec3Of<F> unit) {
    const F sum = abs(unit.x) + abs(unit.y) + abs(unit.z);
    return 4.0F * (sum * sum * sum);
}

/// EnvironmentDraw::density().
template <typename F>
HWY_INLINE F environmentDensity(const EnvironmentRows& rows, Vec3Of<F> direction) {
    const IntOf<F> cell = octahedronTexel<F>(direction, rows.side);
    const auto cells = static_cast<float>(rows.side * rows.side);
    return probabilityOf<F>(rows.cells, toUint(cell)) * cells / octahedronScale<F>(direction);
}

/// EnvironmentDraw::draw().
template <typename F>
HWY_INLINE DirectionDraw<F> drawEnvironment(const EnvironmentRows& rows, F u, F v, UintOf<F> bits) {
    const UintOf<F> cell = drawIndex<F>(rows.cells, bits);
    const auto column = toInt(cell & UintOf<F>(static_cast<std::uint32_t>(rows.side - 1)));
    const auto row = toInt(cell >> rows.sideBits);
    const float step = 1 / static_cast<float>(rows.side);
    const Vec3Of<F> folded = octahedronDirection<F>((toFloat(column) + u) * step, (toFloat(row) + v) * step);
    const Vec3Of<F> direction = folded / sqrt(dot(folded, folded));
    return {direction, environmentDensity<F>(rows, direction)};
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
