// Fog in vectors of rays: elementary functions in single precision, made of products, sums and quotients in a
// fixed order, so that they give the same bits on every instruction set; and shading/fog.h with them.
// Included once for each set, inside foreach_target.h's loop.
#include "rtcore/shading/fog.h"
#include "rtcore/shading/vector_math-inl.h"

#if defined(RTCORE_SHADING_FOG_MATH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_SHADING_FOG_MATH_INL_H_
#undef RTCORE_SHADING_FOG_MATH_INL_H_
#else
#define RTCORE_SHADING_FOG_MATH_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// c[0] + x (c[1] + x (c[2] + ...))
template <std::size_t n>
HWY_INLINE Floats polynomial(const float (&c)[n], Floats x) {
    Floats sum = constant(c[n - 1]);
    for (std::size_t i = n - 1; i-- > 0;) sum = hn::Add(constant(c[i]), hn::Mul(x, sum));
    return sum;
}

/// e^x; 0 below -87, as e^87 above; relative error below 2e-7. (Cephes expf)
HWY_INLINE Floats expOf(Floats x) {
    const FloatTag d;
    const hn::RebindToSigned<FloatTag> di;
    const Lanes possible = hn::Ge(x, constant(-87));
    x = smaller(hn::IfThenElseZero(possible, x), constant(87));
    const Floats whole = hn::Floor(hn::Add(hn::Mul(x, constant(1.44269504F)), constant(0.5F)));
    const Floats f = hn::Sub(hn::Sub(x, hn::Mul(whole, constant(0.693359375F))),
                             hn::Mul(whole, constant(-2.12194440e-4F)));
    static constexpr float kSeries[] = {5.0000001201e-1F, 1.6666665459e-1F, 4.1665795894e-2F,
                                        8.3334519073e-3F, 1.3981999507e-3F, 1.9875691500e-4F};
    const Floats sum = hn::Add(hn::Add(hn::Mul(hn::Mul(f, f), polynomial(kSeries, f)), f), constant(1));
    const auto power = hn::ShiftLeft<23>(hn::Add(hn::ConvertTo(di, whole), hn::Set(di, 127)));
    return hn::IfThenElseZero(possible, hn::Mul(sum, hn::BitCast(d, power)));
}

/// ln x of normal finite x > 0; error below 2e-7 of the larger of 1 and the result. (Cephes logf)
HWY_INLINE Floats logOf(Floats x) {
    const FloatTag d;
    const BitsTag du;
    const hn::RebindToSigned<FloatTag> di;
    const Bits bits = hn::BitCast(du, x);
    const Floats exponent =
        hn::ConvertTo(d, hn::Sub(hn::BitCast(di, hn::ShiftRight<23>(bits)), hn::Set(di, 126)));
    const Floats mantissa =
        hn::BitCast(d, hn::Or(hn::And(bits, hn::Set(du, 0x7FFFFFU)), hn::Set(du, 0x3F000000U)));
    const Lanes lower = hn::Lt(mantissa, constant(0.707106781F));
    const Floats m = hn::Sub(hn::Add(mantissa, hn::IfThenElseZero(lower, mantissa)), constant(1));
    const Floats e = hn::Sub(exponent, hn::IfThenElseZero(lower, constant(1)));
    static constexpr float kSeries[] = {3.3333331174e-1F,  -2.4999993993e-1F, 2.0000714765e-1F,
                                        -1.6668057665e-1F, 1.4249322787e-1F,  -1.2420140846e-1F,
                                        1.1676998740e-1F,  -1.1514610310e-1F, 7.0376836292e-2F};
    const Floats square = hn::Mul(m, m);
    Floats sum = hn::Mul(hn::Mul(m, square), polynomial(kSeries, m));
    sum = hn::Add(sum, hn::Mul(e, constant(-2.12194440e-4F)));
    sum = hn::Sub(sum, hn::Mul(constant(0.5F), square));
    return hn::Add(hn::Add(m, sum), hn::Mul(e, constant(0.693359375F)));
}

/// (1 - e^-x) / x by its series, for 0 <= x <= 0.25.
HWY_INLINE Floats meanDecaySeries(Floats x) {
    static constexpr float kSeries[] = {1, -1.0F / 2, 1.0F / 6, -1.0F / 24, 1.0F / 120, -1.0F / 720};
    return polynomial(kSeries, x);
}

/// (1 - e^-x) / x for x >= 0, also of infinity.
HWY_INLINE Floats meanDecay(Floats x) {
    const Floats high = hn::Div(hn::Sub(constant(1), expOf(hn::Neg(x))), x);
    return hn::IfThenElse(hn::Lt(x, constant(0.25F)), meanDecaySeries(smaller(x, constant(0.25F))), high);
}

/// -ln(1 - u) for 0 <= u < 1, to the last digits of small ones too.
HWY_INLINE Floats minusLogOfRest(Floats u) {
    static constexpr float kSeries[] = {1,        1.0F / 2, 1.0F / 3, 1.0F / 4,
                                        1.0F / 5, 1.0F / 6, 1.0F / 7, 1.0F / 8};
    const Floats low = hn::Mul(u, polynomial(kSeries, smaller(u, constant(0.125F))));
    const Floats rest = larger(hn::Sub(constant(1), u), constant(1e-30F));
    return hn::IfThenElse(hn::Lt(u, constant(0.125F)), low, hn::Neg(logOf(rest)));
}

struct VectorFog {
    HWY_INLINE explicit VectorFog(const FogMedium& fog)
        : density(constant(fog.density)), perHeight(constant(fog.perHeight)),
          up(constant(fog.up.x, fog.up.y, fog.up.z)), ground(constant(fog.ground)) {}

    HWY_INLINE Floats height(Vectors position) const {
        return larger(hn::Mul(hn::Sub(dot(up, position), ground), perHeight), constant(FogMedium::kLowest));
    }
    HWY_INLINE Floats slope(Vectors direction) const { return hn::Mul(dot(up, direction), perHeight); }

    Floats density, perHeight;
    Vectors up;
    Floats ground;
};

/// fogLength() in exponential fog; `from` is the height of the origin in scale heights.
HWY_INLINE Floats exponentialLength(Floats from, Floats slope, Floats distance) {
    const Floats steepness = hn::Abs(slope);
    const Floats to = larger(hn::Add(from, hn::Mul(slope, distance)), constant(FogMedium::kLowest));
    const Floats rise = hn::Mul(steepness, distance);
    const Floats densest = expOf(hn::Neg(smaller(from, to)));
    const Floats ordinary = hn::Mul(hn::Mul(densest, distance), meanDecay(rise));
    return hn::IfThenElse(hn::Gt(rise, constant(16)), hn::Div(densest, steepness), ordinary);
}

template <bool exponential>
HWY_INLINE Floats lengthOf(const VectorFog& fog, Vectors origin, Vectors direction, Floats distance) {
    if constexpr (!exponential) return distance;
    return exponentialLength(fog.height(origin), fog.slope(direction), distance);
}

/// 1 - e^-tau for tau >= 0.
HWY_INLINE Floats opacityOf(Floats tau) {
    const Floats low = hn::Mul(tau, meanDecay(tau));
    return hn::IfThenElse(hn::Lt(tau, constant(16)), low, constant(1));
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
