// Drawing from alias tables, over the number F: float or Float. Included once for each instruction set,
// inside the loop of foreach_target.h, or alone.
#include "rtcore/sampling/alias_table.h"
#include "rtcore/simd/wide-inl.h"

#if defined(RTCORE_SAMPLING_ALIAS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_SAMPLING_ALIAS_INL_H_
#undef RTCORE_SAMPLING_ALIAS_INL_H_
#else
#define RTCORE_SAMPLING_ALIAS_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// An index whose weight is above 0, of a table that is not empty. `bits`: 32 random ones; a float has too
/// few for large tables. `first`: where the table begins, of several that follow each other.
template <typename F>
HWY_INLINE UintOf<F> sampleIndex(const AliasRows& rows, UintOf<F> bits, UintOf<F> first = UintOf<F>(0U)) {
    const UintOf<F> row = bits >> rows.shift, at = first + row;
    const UintOf<F> rest = bits & UintOf<F>((1U << rows.shift) - 1);
    const UintOf<F> threshold = gather(rows.threshold, toInt(at));
    return select(rest < threshold, at, first + gather(rows.other, toInt(at)));
}

/// AliasTable::probability().
template <typename F>
HWY_INLINE F probabilityOf(const AliasRows& rows, UintOf<F> index) {
    return gather(rows.probability, toInt(index));
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
