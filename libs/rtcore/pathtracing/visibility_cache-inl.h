// Lookups in what is known of the visibility of lights, over the number F: float or Float. Included once for
// each instruction set, inside the loop of foreach_target.h, or alone.
#include "rtcore/lights/environment_sampler-inl.h"
#include "rtcore/pathtracing/visibility_cache.h"

#if defined(RTCORE_PATHTRACING_VISIBILITY_CACHE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_PATHTRACING_VISIBILITY_CACHE_INL_H_
#undef RTCORE_PATHTRACING_VISIBILITY_CACHE_INL_H_
#else
#define RTCORE_PATHTRACING_VISIBILITY_CACHE_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// The cell of a point whose surface faces along `normal`; any other numbers have some cell, too.
template <typename F>
HWY_INLINE UintOf<F> cellOf(const VisibilityRows& rows, Vec3Of<F> point, Vec3Of<F> normal) {
    using U = UintOf<F>;
    const F x = abs(normal.x), y = abs(normal.y), z = abs(normal.z);
    const auto alongX = (x >= y) & (x >= z), alongY = y >= z;
    const F along = select(alongX, normal.x, select(alongY, normal.y, normal.z));
    U node = select(alongX, U(0U), select(alongY, U(2U), U(4U))) + select(along < 0.0F, U(1U), U(0U));
    U link = gather(rows.links, toInt(node));
    for (;;) {
        const auto inner = (link & U(VisibilityRows::kLeaf)) == U(0U);
        if (none(inner)) return link & U(~VisibilityRows::kLeaf);
        const U axis = link & U(VisibilityRows::kAxis);
        const F coordinate = select(axis == U(0U), point.x, select(axis == U(1U), point.y, point.z));
        const auto second = coordinate >= gather(rows.splits, toInt(node));
        node = select(inner, (link >> 2) + select(second, U(1U), U(0U)), node);
        link = gather(rows.links, toInt(node));
    }
}

inline constexpr int kBitsOfBin = EnvironmentRows::kBits - 4; ///< of a number, below its bin
static_assert(VisibilityRows::kSide == 1 << 4);

/// 32 bits that lie in the bin, as far in it as the number that chose the bin.
template <typename F>
HWY_INLINE UintOf<F> numberInBin(const IntervalSample<F>& bin) {
    constexpr int kShift = 32 - 4;
    constexpr float kWidth = 1U << kShift;
    const IntOf<F> inside = truncate(min(bin.inside * kWidth, F(kWidth - 64)));
    return toUint(bin.index) << kShift | toUint(inside);
}

/// 32 bits each, for environmentDirection(): by the light that is known to arrive in a cell, where `across`
/// and `down` are random.
template <typename F>
struct VisibleNumbers {
    UintOf<F> across, down;
};
template <typename F>
HWY_INLINE VisibleNumbers<F> visibleNumbers(const VisibilityRows& rows, UintOf<F> cell, UintOf<F> across,
                                            UintOf<F> down) {
    constexpr int kSide = VisibilityRows::kSide, kUnused = 32 - EnvironmentRows::kBits;
    const IntOf<F> ofCell = toInt(cell) * IntOf<F>(kSide);
    const auto row = sampleInterval<F>(rows.rowStarts, ofCell + toInt(cell), kSide, down >> kUnused);
    const auto column = sampleInterval<F>(rows.columnStarts, (ofCell + row.index) * IntOf<F>(kSide + 1),
                                          kSide, across >> kUnused);
    return {numberInBin<F>(column), numberInBin<F>(row)};
}

/// How many times as often sampleVisible() finds a direction as sampleEnvironment() does.
template <typename F>
HWY_INLINE F visibleFactor(const VisibilityRows& rows, UintOf<F> cell, IntOf<F> across, IntOf<F> down) {
    constexpr int kSide = VisibilityRows::kSide;
    const auto binOf = [](IntOf<F> number) HWY_ATTR {
        const IntOf<F> bin = number >> kBitsOfBin, last(kSide - 1);
        return select(bin < last, bin, last);
    };
    const IntOf<F> row = binOf(down), column = binOf(across);
    const IntOf<F> ofCell = toInt(cell) * IntOf<F>(kSide) + row;
    constexpr float kUnit = static_cast<float>(kSide) / (1U << EnvironmentRows::kBits);
    return intervalLength<F>(rows.rowStarts, ofCell + toInt(cell)) * kUnit *
           (intervalLength<F>(rows.columnStarts, ofCell * IntOf<F>(kSide + 1) + column) * kUnit);
}

/// The density of a direction of unit length by sampleVisible() in that cell; by sampleEnvironment() where
/// nothing is known.
template <typename F>
HWY_INLINE F visibleDensity(const EnvironmentRows& surroundings, const VisibilityRows& rows, UintOf<F> cell,
                            Vec3Of<F> direction) {
    const EnvironmentPoint<F> point = environmentPoint<F>(surroundings, direction);
    if (!rows.known()) return point.density;
    return point.density * visibleFactor<F>(rows, cell, point.across, point.down);
}

/// A direction by the light that is known to arrive from there. `across`, `down`: as of sampleEnvironment().
HWY_INLINE EnvironmentSample<Float> sampleVisible(const EnvironmentRows& surroundings,
                                                  const VisibilityRows& rows, Uint cell, Uint across,
                                                  Uint down) {
    if (!rows.known()) return sampleEnvironment<Float>(surroundings, across, down);
    const VisibleNumbers<Float> numbers = visibleNumbers<Float>(rows, cell, across, down);
    const Float3 direction = environmentDirection<Float>(surroundings, numbers.across, numbers.down);
    return {direction, visibleDensity<Float>(surroundings, rows, cell, direction)};
}

/// About how much of the k-th light arrives in that cell, above 0.
template <typename F>
HWY_INLINE F visiblePart(const VisibilityRows& rows, std::uint32_t k, UintOf<F> cell) {
    return gather(rows.lights + k, toInt(cell) * IntOf<F>(rows.lightCount));
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
