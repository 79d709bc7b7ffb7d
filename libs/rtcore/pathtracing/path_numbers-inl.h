// Random numbers for consecutive paths. Included once for each instruction set, inside the loop of
// foreach_target.h, or alone.
#include "rtcore/pathtracing/path_names.h"
#include "rtcore/sampling/owen-inl.h"

#if defined(RTCORE_PATHTRACING_PATH_NUMBERS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_PATHTRACING_PATH_NUMBERS_INL_H_
#undef RTCORE_PATHTRACING_PATH_NUMBERS_INL_H_
#else
#define RTCORE_PATHTRACING_PATH_NUMBERS_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// Tells the points of a path apart, in 24 bits: how often it has scattered, and PathQueue::bounces.
template <typename Bits>
HWY_INLINE Bits visitOf(Bits scatters, Bits bounces) {
    return (scatters & Bits(0x3FFU)) | (bounces & Bits(0x3FFU)) << 10 | (bounces >> 16 & Bits(0xFU)) << 20;
}

struct PathName {
    Uint pixel, sub;
};

/// Of the paths from `i` on; `samples`: which sample each belongs to, null: its own index.
HWY_INLINE PathName pathName(const PathNames& names, const std::uint32_t* samples, std::size_t i, Mask used) {
    if (samples == nullptr) return {load(names.pixel + i), load(names.sub + i)};
    const Int sample = toInt(selectOrZero(used, load(samples + i)));
    return {gather(names.pixel, sample), gather(names.sub, sample)};
}

struct PathNumbers {
    Float u, v;
    Uint bitsOfU, bitsOfV;
};

/// A pair for one use at the points that visitOf() tells.
HWY_INLINE PathNumbers numbersFor(const PathName& name, SampleDimension dimension, Uint visit) {
    const auto pair = pairInSequence<Float>(name.pixel, name.sub, visit | useBits(dimension, 0));
    return {unitFloat(pair.u), unitFloat(pair.v), pair.u, pair.v};
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
