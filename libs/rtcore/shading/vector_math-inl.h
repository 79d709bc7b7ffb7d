// Vector counterparts of math/vec.h and math/portable_math.h: the same operations in the same order, so that
// they give the same bits, on every instruction set. Included once for each of them, inside
// foreach_target.h's loop.
#include <hwy/highway.h>

#include "rtcore/math/vec.h"

#if defined(RTCORE_SHADING_VECTOR_MATH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_SHADING_VECTOR_MATH_INL_H_
#undef RTCORE_SHADING_VECTOR_MATH_INL_H_
#else
#define RTCORE_SHADING_VECTOR_MATH_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = hn::ScalableTag<float>;
using Floats = hn::Vec<FloatTag>;
using Lanes = hn::Mask<FloatTag>;
using BitsTag = hn::RebindToUnsigned<FloatTag>;
using Bits = hn::Vec<BitsTag>;

/// std::max and std::min, NaN included: the first where neither is greater.
HWY_INLINE Floats larger(Floats a, Floats b) { return hn::IfThenElse(hn::Lt(a, b), b, a); }
HWY_INLINE Floats smaller(Floats a, Floats b) { return hn::IfThenElse(hn::Lt(b, a), b, a); }
HWY_INLINE Floats constant(float value) { return hn::Set(FloatTag(), value); }

struct Vectors {
    Floats x, y, z;

    friend HWY_INLINE Vectors operator+(Vectors a, Vectors b) {
        return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
    }
    friend HWY_INLINE Vectors operator-(Vectors a, Vectors b) {
        return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
    }
    friend HWY_INLINE Vectors operator*(Vectors a, Vectors b) {
        return {hn::Mul(a.x, b.x), hn::Mul(a.y, b.y), hn::Mul(a.z, b.z)};
    }
    friend HWY_INLINE Vectors operator*(Vectors a, Floats s) {
        return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s)};
    }
    friend HWY_INLINE Vectors operator/(Vectors a, Floats s) {
        return {hn::Div(a.x, s), hn::Div(a.y, s), hn::Div(a.z, s)};
    }
};

HWY_INLINE Vectors constant(float x, float y, float z) { return {constant(x), constant(y), constant(z)}; }
HWY_INLINE Vectors select(Lanes lanes, Vectors a, Vectors b) {
    return {hn::IfThenElse(lanes, a.x, b.x), hn::IfThenElse(lanes, a.y, b.y),
            hn::IfThenElse(lanes, a.z, b.z)};
}
HWY_INLINE Vectors selectOrZero(Lanes lanes, Vectors a) {
    return {hn::IfThenElseZero(lanes, a.x), hn::IfThenElseZero(lanes, a.y), hn::IfThenElseZero(lanes, a.z)};
}
HWY_INLINE Vectors negateWhere(Lanes lanes, Vectors a) {
    return select(lanes, {hn::Neg(a.x), hn::Neg(a.y), hn::Neg(a.z)}, a);
}
HWY_INLINE Floats dot(Vectors a, Vectors b) {
    return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
HWY_INLINE Vectors cross(Vectors a, Vectors b) {
    return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
            hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}
HWY_INLINE Lanes isZero(Vectors a) {
    const Floats zero = hn::Zero(FloatTag());
    return hn::And(hn::And(hn::Eq(a.x, zero), hn::Eq(a.y, zero)), hn::Eq(a.z, zero));
}

HWY_INLINE Vectors loadVectors(const float* HWY_RESTRICT x, const float* HWY_RESTRICT y,
                               const float* HWY_RESTRICT z) {
    const FloatTag d;
    return {hn::LoadU(d, x), hn::LoadU(d, y), hn::LoadU(d, z)};
}
HWY_INLINE void storeVectors(Vectors a, float* HWY_RESTRICT x, float* HWY_RESTRICT y, float* HWY_RESTRICT z) {
    const FloatTag d;
    hn::StoreU(a.x, d, x);
    hn::StoreU(a.y, d, y);
    hn::StoreU(a.z, d, z);
}

/// rtcore::normalize() one by one.
HWY_NOINLINE inline void normalizeEach(const float* x, const float* y, const float* z, float* out,
                                       std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 unit = rtcore::normalize(Vec3{x[i], y[i], z[i]});
        out[i] = unit.x;
        out[count + i] = unit.y;
        out[2 * count + i] = unit.z;
    }
}

/// The unit vectors in those of the lanes that are in use.
HWY_INLINE Vectors normalize(Vectors a, Lanes used) {
    const FloatTag d;
    const Floats square = dot(a, a);
    const Lanes ordinary = hn::And(hn::Gt(square, constant(1e-28F)), hn::Lt(square, constant(1e28F)));
    const Vectors unit = a / hn::Sqrt(square);
    if (HWY_LIKELY(hn::AllFalse(d, hn::AndNot(ordinary, used)))) return unit;
    constexpr std::size_t kMost = hn::MaxLanes(FloatTag());
    HWY_ALIGN float x[kMost], y[kMost], z[kMost], out[3 * kMost];
    storeVectors(a, x, y, z);
    normalizeEach(x, y, z, out, hn::Lanes(d));
    const std::size_t n = hn::Lanes(d);
    return select(ordinary, unit, loadVectors(out, out + n, out + 2 * n));
}

using DoubleTag = hn::ScalableTag<double>;
using Doubles = hn::Vec<DoubleTag>;
HWY_INLINE Doubles constantDouble(double value) { return hn::Set(DoubleTag(), value); }

/// a + f * b
HWY_INLINE Doubles horner(double a, Doubles f, Doubles b) {
    return hn::Add(constantDouble(a), hn::Mul(f, b));
}

/// log2 of doubles that were finite floats > 0.
HWY_INLINE Doubles log2Vector(Doubles x) {
    const DoubleTag d;
    const hn::RebindToUnsigned<DoubleTag> du;
    const hn::RebindToSigned<DoubleTag> di;
    const auto bits = hn::BitCast(du, x);
    const Doubles exponent =
        hn::Sub(hn::ConvertTo(d, hn::BitCast(di, hn::ShiftRight<52>(bits))), constantDouble(1023));
    const Doubles mantissa = hn::BitCast(
        d, hn::Or(hn::And(bits, hn::Set(du, 0xFFFFFFFFFFFFFULL)), hn::Set(du, 0x3FF0000000000000ULL)));
    const auto upper = hn::Gt(mantissa, constantDouble(1.41421356237309505));
    const Doubles m = hn::IfThenElse(upper, hn::Mul(mantissa, constantDouble(0.5)), mantissa);
    const Doubles e = hn::IfThenElse(upper, hn::Add(exponent, constantDouble(1)), exponent);
    const Doubles s = hn::Div(hn::Sub(m, constantDouble(1)), hn::Add(m, constantDouble(1)));
    const Doubles z = hn::Mul(s, s);
    Doubles sum = horner(1.0 / 9, z, constantDouble(1.0 / 11));
    sum = horner(1.0 / 7, z, sum);
    sum = horner(1.0 / 5, z, sum);
    sum = horner(1.0 / 3, z, sum);
    sum = horner(1, z, sum);
    const Doubles logarithm = hn::Mul(hn::Mul(constantDouble(2), s), sum);
    return hn::Add(e, hn::Mul(logarithm, constantDouble(1.44269504088896340736)));
}

/// 2^x of x <= 129.
HWY_INLINE Doubles exp2Vector(Doubles x) {
    const DoubleTag d;
    const hn::RebindToSigned<DoubleTag> di;
    const auto possible = hn::Ge(x, constantDouble(-150));
    x = hn::IfThenElseZero(possible, x);
    const Doubles whole = hn::Floor(hn::Add(x, constantDouble(0.5)));
    const Doubles f = hn::Mul(hn::Sub(x, whole), constantDouble(0.69314718055994530942));
    Doubles sum = hn::Add(constantDouble(1.0 / 5040), hn::Div(f, constantDouble(40320)));
    sum = horner(1.0 / 720, f, sum);
    sum = horner(1.0 / 120, f, sum);
    sum = horner(1.0 / 24, f, sum);
    sum = horner(1.0 / 6, f, sum);
    sum = horner(1.0 / 2, f, sum);
    sum = horner(1, f, sum);
    sum = horner(1, f, sum);
    const auto exponent = hn::ShiftLeft<52>(hn::Add(hn::ConvertTo(di, whole), hn::Set(di, 1023)));
    return hn::IfThenElseZero(possible, hn::Mul(sum, hn::BitCast(d, exponent)));
}

/// portablePow() of 0 < x <= 2 and 0 < y, in place: x becomes x^y. `count` is a multiple of the lanes of
/// doubles.
HWY_INLINE void powArray(float* HWY_RESTRICT x, const float* HWY_RESTRICT y, std::size_t count) {
    const DoubleTag d;
    const hn::Rebind<float, DoubleTag> df;
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const Doubles base = hn::PromoteTo(d, hn::LoadU(df, x + i));
        const Doubles exponent = hn::PromoteTo(d, hn::LoadU(df, y + i));
        hn::StoreU(hn::DemoteTo(df, exp2Vector(hn::Mul(exponent, log2Vector(base)))), df, x + i);
    }
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
