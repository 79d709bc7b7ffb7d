// Where in the cells of an environment's images a direction is, and back, over the number F: float or Float.
// Included once for each instruction set, inside the loop of foreach_target.h, or alone.
#include "rtcore/lights/environment_sampler.h"
#include "rtcore/math/constants.h"
#include "rtcore/math/float3-inl.h"
#include "rtcore/simd/functions-inl.h"

#if defined(RTCORE_LIGHTS_ENVIRONMENT_CELLS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_LIGHTS_ENVIRONMENT_CELLS_INL_H_
#undef RTCORE_LIGHTS_ENVIRONMENT_CELLS_INL_H_
#else
#define RTCORE_LIGHTS_ENVIRONMENT_CELLS_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

template <typename F>
struct CellPoint {
    F row, column;   ///< whole numbers; the row of all images
    F right, down;   ///< 0..1 of the cell, from its upper left corner
    F perSolidAngle; ///< how much of the unit square that right and down span
};

/// Along one side of an image, in texels: the cell k begins in the middle of the texel k - 1.
template <typename F>
struct CellSpan {
    F start, length;
};
template <typename F>
HWY_INLINE CellSpan<F> cellSpan(F cell, int cells) {
    const auto atEdge = (cell < 0.5F) | (cell > static_cast<float>(cells) - 1.5F);
    return {max(cell - 0.5F, F(0)), select(atEdge, F(0.5F), F(1))};
}
template <typename F>
HWY_INLINE F cellAt(F texel, int cells) {
    // Zero first: so it is NaN that is dropped.
    return floor(min(max(F(0), texel + 0.5F), F(static_cast<float>(cells - 1))));
}

/// The axis `k` of the image with that number.
template <typename F>
HWY_INLINE Vec3Of<F> axisOf(const EnvironmentRows& rows, F image, int k) {
    const IntOf<F> at = truncate(image * 9.0F);
    const float* const axes = rows.axes + k * 3;
    return {gather(axes, at), gather(axes + 1, at), gather(axes + 2, at)};
}
HWY_INLINE Vec3 axisOf(const EnvironmentRows& rows, int image, int k) {
    const float* const axis = rows.axes + image * 9 + k * 3;
    return {axis[0], axis[1], axis[2]};
}

/// Depths below the pole at the edges of a row of cells on a sphere. Rows of the lower half have those of the
/// upper one, seen from the other pole: so depths are as exact at both.
template <typename F>
struct RowDepths {
    F start, end;
    decltype(F(0) < F(0)) lower;
};
template <typename F>
HWY_INLINE RowDepths<F> rowDepths(const EnvironmentRows& rows, F row) {
    const auto last = static_cast<float>(rows.rows - 1);
    const auto lower = row > 0.5F * last;
    const IntOf<F> at = truncate(select(lower, last - row, row));
    return {gather(rows.depths, at), gather(rows.depths + 1, at), lower};
}

/// Light of one image is even in the azimuth and in the depth, not in the angle from the pole: so solid
/// angles are exact.
template <typename F>
HWY_INLINE CellPoint<F> pointOfSphere(const EnvironmentRows& rows, Vec3Of<F> direction) {
    const F x = dot(direction, broadcast<F>(axisOf(rows, 0, 0)));
    const F y = dot(direction, broadcast<F>(axisOf(rows, 0, 1)));
    const F z = dot(direction, broadcast<F>(axisOf(rows, 0, 2)));
    const auto width = static_cast<float>(rows.columns - 1), height = static_cast<float>(rows.rows - 1);
    const F texel = (fastAtan2<F>(x, -z) * (0.5F / kPi) + 0.5F) * width;
    const F column = cellAt<F>(texel, rows.columns);
    const CellSpan<F> across = cellSpan<F>(column, rows.columns);

    const F square = x * x + z * z;
    const F row = cellAt<F>(fastAtan2<F>(sqrt(square), y) * (height / kPi), rows.rows);
    const RowDepths<F> edges = rowDepths<F>(rows, row);
    const F up = select(edges.lower, -y, y);
    const F depth = select(up > 0.0F, square / (1.0F + up), 1.0F - up);
    const F inside = clamp((depth - edges.start) / (edges.end - edges.start), 0.0F, 1.0F);
    const F solidAngle = across.length * (2 * kPi / width) * (edges.end - edges.start);
    return {row, column, clamp((texel - across.start) / across.length, 0.0F, 1.0F),
            select(edges.lower, 1.0F - inside, inside), 1.0F / solidAngle};
}
template <typename F>
HWY_INLINE Vec3Of<F> directionOfSphere(const EnvironmentRows& rows, F row, F column, F right, F down) {
    const CellSpan<F> across = cellSpan<F>(column, rows.columns);
    const auto circle =
        unitCircle<F>((across.start + right * across.length) / static_cast<float>(rows.columns - 1));
    const RowDepths<F> edges = rowDepths<F>(rows, row);
    const F inside = select(edges.lower, 1.0F - down, down);
    const F depth = edges.start + inside * (edges.end - edges.start);
    const F ring = sqrt(max(depth * (2.0F - depth), F(0)));
    const F up = 1.0F - depth;
    // The middle of the image is straight ahead, along -z.
    return broadcast<F>(axisOf(rows, 0, 0)) * (-ring * circle.sine) +
           broadcast<F>(axisOf(rows, 0, 1)) * select(edges.lower, -up, up) +
           broadcast<F>(axisOf(rows, 0, 2)) * (ring * circle.cosine);
}

template <typename F>
HWY_INLINE CellPoint<F> pointOfCube(const EnvironmentRows& rows, Vec3Of<F> direction) {
    F face = F(0), ahead = F(-1), right = F(0), down = F(0);
    for (int k = 0; k < 6; ++k) {
        const F along = dot(direction, broadcast<F>(axisOf(rows, k, 0)));
        const auto nearer = along > ahead;
        face = select(nearer, F(static_cast<float>(k)), face);
        ahead = select(nearer, along, ahead);
        right = select(nearer, dot(direction, broadcast<F>(axisOf(rows, k, 1))), right);
        down = select(nearer, dot(direction, broadcast<F>(axisOf(rows, k, 2))), down);
    }
    const auto side = static_cast<float>(rows.columns - 1);
    const F x = (right / ahead * 0.5F + 0.5F) * side, y = (down / ahead * 0.5F + 0.5F) * side;
    const F column = cellAt<F>(x, rows.columns), row = cellAt<F>(y, rows.rows);
    const CellSpan<F> across = cellSpan<F>(column, rows.columns), along = cellSpan<F>(row, rows.rows);
    const F solidAngle = across.length * along.length * (4 / (side * side)) * (ahead * ahead * ahead);
    return {face * static_cast<float>(rows.rows) + row, column,
            clamp((x - across.start) / across.length, 0.0F, 1.0F),
            clamp((y - along.start) / along.length, 0.0F, 1.0F), 1.0F / solidAngle};
}
template <typename F>
HWY_INLINE F imageOfRow(const EnvironmentRows& rows, F row) {
    return floor((row + 0.5F) / static_cast<float>(rows.rows));
}
template <typename F>
HWY_INLINE Vec3Of<F> directionOfCube(const EnvironmentRows& rows, F row, F column, F right, F down) {
    const F face = imageOfRow<F>(rows, row);
    const F ofFace = row - face * static_cast<float>(rows.rows);
    const CellSpan<F> across = cellSpan<F>(column, rows.columns), along = cellSpan<F>(ofFace, rows.rows);
    const float step = 2 / static_cast<float>(rows.columns - 1);
    const F x = (across.start + right * across.length) * step - 1.0F;
    const F y = (along.start + down * along.length) * step - 1.0F;
    return axisOf<F>(rows, face, 0) + axisOf<F>(rows, face, 1) * x + axisOf<F>(rows, face, 2) * y;
}

/// `direction`: of unit length.
template <typename F>
HWY_INLINE CellPoint<F> pointOfDirection(const EnvironmentRows& rows, Vec3Of<F> direction) {
    return rows.cube ? pointOfCube<F>(rows, direction) : pointOfSphere<F>(rows, direction);
}
/// Returns a unit vector.
template <typename F>
HWY_INLINE Vec3Of<F> directionOfPoint(const EnvironmentRows& rows, F row, F column, F right, F down) {
    const Vec3Of<F> d = rows.cube ? directionOfCube<F>(rows, row, column, right, down)
                                  : directionOfSphere<F>(rows, row, column, right, down);
    return d / sqrt(dot(d, d));
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
