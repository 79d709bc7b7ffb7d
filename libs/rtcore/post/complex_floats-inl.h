// Vectors of complex numbers. Included once for each instruction set, inside foreach_target.h's loop.
#include "rtcore/simd/wide-inl.h"

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
    Float re, im;

    friend HWY_INLINE ComplexFloats operator*(ComplexFloats a, ComplexFloats b) {
        return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
    }
    friend HWY_INLINE ComplexFloats operator+(ComplexFloats a, ComplexFloats b) {
        return {a.re + b.re, a.im + b.im};
    }
    friend HWY_INLINE ComplexFloats operator-(ComplexFloats a, ComplexFloats b) {
        return {a.re - b.re, a.im - b.im};
    }
};

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
