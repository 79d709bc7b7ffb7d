// Points of discs, over the number F: float or Float. Included once for each instruction set, inside the loop
// of foreach_target.h, or alone.
#include "rtcore/simd/functions-inl.h"

#if defined(RTCORE_SAMPLING_DISC_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_SAMPLING_DISC_INL_H_
#undef RTCORE_SAMPLING_DISC_INL_H_
#else
#define RTCORE_SAMPLING_DISC_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

template <typename F>
struct Disc {
    F x, y;
};

/// The point of the unit disc for one of the unit square: areas keep their ratio, neighbours stay neighbours
/// (Shirley and Chiu 1997). An angle of up to 45 degrees from the nearer axis, and the sine and cosine of it
/// to 1e-7.
template <typename F>
HWY_INLINE Disc<F> onDisc(F u, F v) {
    const F a = u + u - 1.0F, b = v + v - 1.0F;
    const auto across = abs(a) > abs(b);
    const F r = select(across, a, b), other = select(across, b, a);
    const F angle = 0.785398163397F * (other / r);
    static constexpr float kSine[] = {1, -1.0F / 6, 1.0F / 120, -1.0F / 5040, 1.0F / 362880};
    static constexpr float kCosine[] = {1, -1.0F / 2, 1.0F / 24, -1.0F / 720, 1.0F / 40320, -1.0F / 3628800};
    const F z = angle * angle;
    const F along = r * polynomial(kCosine, z), aside = r * (angle * polynomial(kSine, z));
    const auto out = r != 0.0F;
    return {selectOrZero(out, select(across, along, aside)), selectOrZero(out, select(across, aside, along))};
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
