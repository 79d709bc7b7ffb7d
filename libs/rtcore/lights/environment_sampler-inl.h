// Directions sampled by the brightness of an environment, over the number F: float or Float. Included once
// for each instruction set, inside the loop of foreach_target.h, or alone.
#include "rtcore/lights/environment_cells-inl.h"

#if defined(RTCORE_LIGHTS_ENVIRONMENT_SAMPLER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_LIGHTS_ENVIRONMENT_SAMPLER_INL_H_
#undef RTCORE_LIGHTS_ENVIRONMENT_SAMPLER_INL_H_
#else
#define RTCORE_LIGHTS_ENVIRONMENT_SAMPLER_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

template <typename F>
struct EnvironmentSample {
    Vec3Of<F> direction; ///< unit
    F density;           ///< by solid angle
};

/// Which of `count` intervals a number falls into, and where in it.
template <typename F>
struct IntervalSample {
    IntOf<F> index;
    F inside; ///< 0..1
};
/// `starts`: of the intervals from `first` on, then the end of the last. `number` lies in them.
template <typename F>
HWY_INLINE IntervalSample<F> sampleInterval(const std::uint32_t* starts, IntOf<F> first, int count,
                                            UintOf<F> number) {
    int step = 1;
    while (step < count) step *= 2;
    IntOf<F> index(0), last(count);
    for (step /= 2; step > 0; step /= 2) {
        const IntOf<F> middle = index + IntOf<F>(step);
        const IntOf<F> some = select(middle < last, middle, last);
        const auto behind = number < gather(starts, first + some);
        index = select(behind, index, some);
    }
    const UintOf<F> start = gather(starts, first + index), end = gather(starts + 1, first + index);
    return {index, (toFloat(toInt(number - start)) + 0.5F) / toFloat(toInt(end - start))};
}
/// The length of an interval, of all of them 2^EnvironmentRows::kBits.
template <typename F>
HWY_INLINE F intervalLength(const std::uint32_t* starts, IntOf<F> index) {
    return toFloat(toInt(gather(starts + 1, index) - gather(starts, index)));
}

/// Brightness at the corners of a cell.
template <typename F>
struct CellCorners {
    F upperLeft, upperRight, lowerLeft, lowerRight;

    HWY_INLINE F left(F down) const { return upperLeft + down * (lowerLeft - upperLeft); }
    HWY_INLINE F right(F down) const { return upperRight + down * (lowerRight - upperRight); }
    HWY_INLINE F mean() const { return (upperLeft + upperRight + lowerLeft + lowerRight) * 0.25F; }
};
template <typename F>
HWY_INLINE CellCorners<F> cornersOf(const EnvironmentRows& rows, F row, IntOf<F> column) {
    // An image has one row of corners more than of cells.
    const F ofCorners = row + imageOfRow<F>(rows, row);
    const float* const upper = rows.corners;
    const float* const lower = upper + rows.columns + 1;
    const IntOf<F> at = truncate(ofCorners) * IntOf<F>(rows.columns + 1) + column;
    return {gather(upper, at), gather(upper + 1, at), gather(lower, at), gather(lower + 1, at)};
}

/// Distributes 0..1 by a density that goes from `from` to `to`, which are above 0.
template <typename F>
HWY_INLINE F sampleLinearDensity(F number, F from, F to) {
    const F square = from * from + number * (to * to - from * from);
    return min(number * (from + to) / (from + sqrt(square)), F(1));
}

/// The fraction of such a density that lies below `t`, 0..1.
template <typename F>
HWY_INLINE F cumulativeLinearDensity(F t, F from, F to) {
    return t * (from + from + t * (to - from)) / (from + to);
}

/// The number that chooses an interval, and the position `inside` it, 0..1.
template <typename F>
HWY_INLINE IntOf<F> numberInInterval(const std::uint32_t* starts, IntOf<F> index, F inside) {
    const F length = intervalLength<F>(starts, index);
    const IntOf<F> first = toInt(gather(starts, index));
    // Zero first: so it is NaN that is dropped.
    return first + truncate(min(max(F(0), inside * length), length - 1.0F));
}

/// Where sampleEnvironment() finds a direction.
template <typename F>
struct EnvironmentPoint {
    F density;             ///< by solid angle, above 0: of a direction it gave, the same number to the bit
    IntOf<F> across, down; ///< the numbers that it makes the direction of, but for rounding: of kBits bits
};
/// `direction`: of unit length. There is light.
template <typename F>
HWY_INLINE EnvironmentPoint<F> environmentPoint(const EnvironmentRows& rows, Vec3Of<F> direction) {
    const CellPoint<F> point = pointOfDirection<F>(rows, direction);
    const IntOf<F> row = truncate(point.row);
    const IntOf<F> column = row * IntOf<F>(rows.columns + 1) + truncate(point.column);
    const F ofRow = intervalLength<F>(rows.rowStarts, row);
    const F ofCell = intervalLength<F>(rows.columnStarts, column);
    const CellCorners<F> corners = cornersOf<F>(rows, point.row, truncate(point.column));
    const F left = corners.left(point.down), right = corners.right(point.down);
    const F here = left + point.right * (right - left);
    constexpr float kUnit = 1.0F / (1U << EnvironmentRows::kBits);
    const F density = ofRow * kUnit * (ofCell * kUnit) * point.perSolidAngle * (here / corners.mean());
    const F x = cumulativeLinearDensity<F>(point.right, left, right);
    const F y = cumulativeLinearDensity<F>(point.down, corners.upperLeft + corners.upperRight,
                                           corners.lowerLeft + corners.lowerRight);
    return {density, numberInInterval<F>(rows.columnStarts, column, x),
            numberInInterval<F>(rows.rowStarts, row, y)};
}
template <typename F>
HWY_INLINE F environmentDensity(const EnvironmentRows& rows, Vec3Of<F> direction) {
    return environmentPoint<F>(rows, direction).density;
}

/// A direction by the light that comes from there, a unit vector. There is some. `across`, `down`: 32 random
/// bits each, a point of the square: directions are as evenly spread as such points are. What shines from
/// there is BackgroundLight::radiance() of it.
template <typename F>
HWY_INLINE Vec3Of<F> environmentDirection(const EnvironmentRows& rows, UintOf<F> across, UintOf<F> down) {
    constexpr int kUnused = 32 - EnvironmentRows::kBits;
    const auto row = sampleInterval<F>(rows.rowStarts, IntOf<F>(0), rows.allRows, down >> kUnused);
    const auto column = sampleInterval<F>(rows.columnStarts, row.index * IntOf<F>(rows.columns + 1),
                                          rows.columns, across >> kUnused);
    const F ofRow = toFloat(row.index);
    const CellCorners<F> corners = cornersOf<F>(rows, ofRow, column.index);
    const F y = sampleLinearDensity<F>(row.inside, corners.upperLeft + corners.upperRight,
                                       corners.lowerLeft + corners.lowerRight);
    const F x = sampleLinearDensity<F>(column.inside, corners.left(y), corners.right(y));
    return directionOfPoint<F>(rows, ofRow, toFloat(column.index), x, y);
}
template <typename F>
HWY_INLINE EnvironmentSample<F> sampleEnvironment(const EnvironmentRows& rows, UintOf<F> across,
                                                  UintOf<F> down) {
    const Vec3Of<F> direction = environmentDirection<F>(rows, across, down);
    return {direction, environmentDensity<F>(rows, direction)};
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
