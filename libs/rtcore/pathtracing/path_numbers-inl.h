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

/// A number for each point of a path: how often it has scattered, been mirrored or bent, and passed straight
/// through.
template <typename Bits>
struct Visit {
    Bits usual;  ///< 24 bits, which nearly all paths can do with
    Bits beyond; ///< what does not fit into these; else 0
};
/// `scatters` < 2^16; `bounces`: PathQueue::bounces.
template <typename Bits>
HWY_INLINE Visit<Bits> visitOf(Bits scatters, Bits bounces) {
    const Bits depth = bounces & Bits(0xFFFFU), passes = bounces >> 16 & Bits(0x7FFFU);
    return {(scatters & Bits(0x3FFU)) | (depth & Bits(0x3FFU)) << 10 | (passes & Bits(0xFU)) << 20,
            scatters >> 10 | depth >> 10 << 6 | passes >> 4 << 12};
}

/// The name of the numbers that a pixel's paths use there for `dimension`.
template <typename Bits>
HWY_INLINE Bits nameOfNumbers(Bits pixel, SampleDimension dimension, const Visit<Bits>& visit) {
    return nameOfUse(pixel ^ mixBits(visit.beyond), visit.usual | Bits(useBits(dimension, 0)));
}

struct PathName {
    Uint pixel, sub;
};

/// Names of the paths from `i` on; `samples`: which sample each belongs to, null: of camera rays.
HWY_INLINE PathName pathName(const PathNames& names, const std::uint32_t* samples, std::size_t i, Mask used) {
    if (samples == nullptr) return {load(names.pixel + names.first + i), load(names.sub + names.first + i)};
    const Int sample = toInt(selectOrZero(used, load(samples + i)));
    return {gather(names.pixel, sample), gather(names.sub, sample)};
}

struct PathNumbers {
    Float u, v;
    Uint bitsOfU, bitsOfV;
};

/// A pair for one use at those points.
HWY_INLINE PathNumbers numbersFor(const PathName& name, SampleDimension dimension, const Visit<Uint>& visit) {
    const auto pair = owenPair(name.sub, nameOfNumbers(name.pixel, dimension, visit));
    return {unitFloat(pair.u), unitFloat(pair.v), pair.u, pair.v};
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
