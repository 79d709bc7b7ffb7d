// Points of the unit circle and directions around an axis, of vectors of numbers; the same bits on every
// instruction set. Included once for each of them, inside foreach_target.h's loop.
#include "rtcore/shading/vector_math-inl.h"

#if defined(RTCORE_SHADING_VECTOR_CIRCLE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_SHADING_VECTOR_CIRCLE_INL_H_
#undef RTCORE_SHADING_VECTOR_CIRCLE_INL_H_
#else
#define RTCORE_SHADING_VECTOR_CIRCLE_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

struct UnitCircle {
    Floats cosine, sine;
};

/// Of 0 <= turns <= 1; absolute error below 3e-7. An eighth of a turn to each side of an axis by Taylor's
/// series, the rest by symmetry.
HWY_INLINE UnitCircle unitCircle(Floats turns) {
    const FloatTag d;
    const hn::RebindToSigned<FloatTag> di;
    const auto quarter =
        hn::ConvertTo(di, hn::Add(hn::Mul(turns, constant(4)), constant(0.5F))); // 0..4, truncated
    const Floats from = hn::Mul(hn::ConvertTo(d, quarter), constant(0.25F));
    const Floats a = hn::Mul(hn::Sub(turns, from), constant(6.28318531F));
    const Floats z = hn::Mul(a, a);
    const auto horner = [&z](float c, Floats sum) { return hn::Add(constant(c), hn::Mul(z, sum)); };
    const Floats s = hn::Mul(a, horner(1, horner(-1.0F / 6, horner(1.0F / 120, constant(-1.0F / 5040)))));
    const Floats c = horner(1, horner(-0.5F, horner(1.0F / 24, horner(-1.0F / 720, constant(1.0F / 40320)))));
    const auto bit = [&](int which) {
        const auto set = hn::Ne(hn::And(quarter, hn::Set(di, which)), hn::Zero(di));
        return hn::MaskFromVec(hn::BitCast(d, hn::VecFromMask(di, set)));
    };
    const Lanes odd = bit(1), half = bit(2);
    const Floats x = hn::IfThenElse(odd, hn::Neg(s), c), y = hn::IfThenElse(odd, c, s);
    return {hn::IfThenElse(half, hn::Neg(x), x), hn::IfThenElse(half, hn::Neg(y), y)};
}

/// cosine * tangent + sine * bitangent of rtcore::basisAround(axis).
HWY_INLINE Vectors aroundAxis(Vectors axis, UnitCircle at) {
    const Floats one = constant(1);
    const Floats sign = hn::CopySign(one, axis.z);
    const Floats a = hn::Div(constant(-1), hn::Add(sign, axis.z));
    const Floats b = hn::Mul(hn::Mul(axis.x, axis.y), a);
    const Vectors tangent{hn::Add(one, hn::Mul(hn::Mul(hn::Mul(sign, axis.x), axis.x), a)), hn::Mul(sign, b),
                          hn::Mul(hn::Neg(sign), axis.x)};
    const Vectors bitangent{b, hn::Add(sign, hn::Mul(hn::Mul(axis.y, axis.y), a)), hn::Neg(axis.y)};
    return tangent * at.cosine + bitangent * at.sine;
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
