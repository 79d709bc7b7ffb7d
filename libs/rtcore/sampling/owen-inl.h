// Random numbers of paths by name, over the number F: float or Float; the same bits as pointInSequence() of
// sample_id.h. Included once for each instruction set, inside the loop of foreach_target.h, or alone.
#include "rtcore/sampling/sample_id.h"
#include "rtcore/simd/wide-inl.h"

#if defined(RTCORE_SAMPLING_OWEN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_SAMPLING_OWEN_INL_H_
#undef RTCORE_SAMPLING_OWEN_INL_H_
#else
#define RTCORE_SAMPLING_OWEN_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

#define RT_FORMULA HWY_INLINE
#define RT_BITS Uint
#include "rtcore/sampling/random_bits_text.h"
#undef RT_BITS
#undef RT_FORMULA

// For one number.
using rtcore::mixBits;
using rtcore::nameOfPixel;
using rtcore::nameOfUse;
using rtcore::owenPair;
using rtcore::unitFloat;

/// 0 <= u < 1 from the upper 24 bits.
HWY_INLINE Float unitFloat(Uint bits) { return toFloat(toInt(bits >> 8)) * 0x1p-24F; }

template <typename F>
struct SquarePointOf {
    F u, v; ///< 0..1, without 1
};

/// Point number `sample` of the sequence for `use` (useBits()) of the pixel with this pixelName().
template <typename F>
HWY_INLINE auto pairInSequence(UintOf<F> pixel, UintOf<F> sample, UintOf<F> use) {
    return owenPair(sample, nameOfUse(pixel, use));
}
template <typename F>
HWY_INLINE SquarePointOf<F> pointInSequence(UintOf<F> pixel, UintOf<F> sample, UintOf<F> use) {
    const auto pair = pairInSequence<F>(pixel, sample, use);
    return {unitFloat(pair.u), unitFloat(pair.v)};
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
