// Vectors of complex numbers. Included once for each instruction set, inside foreach_target.h's loop.
#include "rtcore/shading/vector_math-inl.h"

#if defined(RTCORE_POST_COMPLEX_FLOATS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_POST_COMPLEX_FLOATS_INL_H_
#undef RTCORE_POST_COMPLEX_FLOATS_INL_H_
#else
#define RTCORE_POST_COMPLEX_FLOATS_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

struct ComplexFloats {
    Floats re, im;

    friend HWY_INLINE ComplexFloats operator*(ComplexFloats a, ComplexFloats b) {
        return {hn::Sub(hn::Mul(a.re, b.re), hn::Mul(a.im, b.im)),
                hn::Add(hn::Mul(a.re, b.im), hn::Mul(a.im, b.re))};
    }
    friend HWY_INLINE ComplexFloats operator+(ComplexFloats a, ComplexFloats b) {
        return {hn::Add(a.re, b.re), hn::Add(a.im, b.im)};
    }
    friend HWY_INLINE ComplexFloats operator-(ComplexFloats a, ComplexFloats b) {
        return {hn::Sub(a.re, b.re), hn::Sub(a.im, b.im)};
    }
};

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
