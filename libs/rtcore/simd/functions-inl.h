// Elementary functions that give the same bits on every processor, in every instruction set and in each lane:
// made of sums, products, quotients and roots in a fixed order. The C library's choose their code by the
// processor (fused multiply-add or not), so that two machines of one farm would render films that differ.
// Included once for each instruction set, inside the loop of foreach_target.h, or alone.
//
// Two kinds: in double, for what is kept to the last digit of a float (portable_math.h tells their errors);
// and in single precision, named fast..., where vectors are many and some last digits of a float do not show.
#include "rtcore/simd/portable_math.h"
#include "rtcore/simd/wide-inl.h"

#include <array>
#include <bit>

#if defined(RTCORE_SIMD_FUNCTIONS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_SIMD_FUNCTIONS_INL_H_
#undef RTCORE_SIMD_FUNCTIONS_INL_H_
#else
#define RTCORE_SIMD_FUNCTIONS_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// c[0] + x (c[1] + x (c[2] + ...)), by Horner's rule.
template <typename F, typename C, std::size_t n>
HWY_INLINE F polynomial(const C (&c)[n], F x) {
    F sum = c[n - 1];
    for (std::size_t i = n - 1; i-- > 0;) sum = c[i] + x * sum;
    return sum;
}

// --- In double ---

HWY_INLINE double select(bool where, double a, double b) { return where ? a : b; }
HWY_INLINE double selectOrZero(bool where, double a) { return where ? a : 0; }
HWY_INLINE double floor(double a) { return std::floor(a); }
HWY_INLINE double abs(double a) { return std::fabs(a); }
HWY_INLINE double copySign(double size, double sign) { return std::copysign(size, sign); }
HWY_INLINE Double floor(Double a) { return hn::Floor(a.raw); }

/// x = mantissa * 2^exponent, 1 <= mantissa < 2, of normal x > 0.
template <typename D>
struct Scaled {
    D mantissa, exponent;
};
HWY_INLINE Scaled<double> scaled(double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    return {std::bit_cast<double>((bits & 0xFFFFFFFFFFFFFULL) | 0x3FF0000000000000ULL),
            static_cast<double>(static_cast<int>(bits >> 52) - 1023)};
}
HWY_INLINE Scaled<Double> scaled(Double x) {
    const Double::Tag d;
    const hn::RebindToUnsigned<Double::Tag> du;
    const hn::RebindToSigned<Double::Tag> di;
    const auto bits = hn::BitCast(du, x.raw);
    const Double biased = hn::ConvertTo(d, hn::BitCast(di, hn::ShiftRight<52>(bits)));
    const auto digits = hn::And(bits, hn::Set(du, 0xFFFFFFFFFFFFFULL));
    return {Double(hn::BitCast(d, hn::Or(digits, hn::Set(du, 0x3FF0000000000000ULL)))), biased - 1023.0};
}
/// 2^whole, of whole numbers from -1022 to 1023.
HWY_INLINE double powerOfTwo(double whole) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(static_cast<std::int64_t>(whole) + 1023) << 52);
}
HWY_INLINE Double powerOfTwo(Double whole) {
    const hn::RebindToSigned<Double::Tag> di;
    const auto biased = hn::Add(hn::ConvertTo(di, whole.raw), hn::Set(di, 1023));
    return hn::BitCast(Double::Tag(), hn::ShiftLeft<52>(biased));
}

/// log2 of what was a finite float > 0: ln m = 2 atanh(s), s = (m - 1) / (m + 1), for m in [sqrt(1/2),
/// sqrt(2)].
template <typename D>
HWY_INLINE D log2Double(D x) {
    const Scaled<D> s = scaled(x);
    const auto upper = s.mantissa > 1.41421356237309505;
    const D m = select(upper, s.mantissa * 0.5, s.mantissa);
    const D exponent = select(upper, s.exponent + 1.0, s.exponent);
    const D ratio = (m - 1.0) / (m + 1.0);
    static constexpr double kSeries[] = {1, 1.0 / 3, 1.0 / 5, 1.0 / 7, 1.0 / 9, 1.0 / 11};
    return exponent + 2.0 * ratio * polynomial(kSeries, ratio * ratio) * 1.44269504088896340736;
}

/// 2^x of x <= 129, 0 below -150: 2^round(x) by its bits, e^(rest ln 2) by its series.
template <typename D>
HWY_INLINE D exp2Double(D x) {
    const auto possible = x >= -150.0;
    x = selectOrZero(possible, x);
    const D whole = floor(x + 0.5);
    const D rest = (x - whole) * 0.69314718055994530942;
    static constexpr double kSeries[] = {1, 1, 1.0 / 2, 1.0 / 6, 1.0 / 24, 1.0 / 120, 1.0 / 720};
    // The last coefficient by division, as ever.
    const D last = 1.0 / 5040 + rest / 40320.0;
    D sum = last;
    for (std::size_t i = std::size(kSeries); i-- > 0;) sum = kSeries[i] + rest * sum;
    return selectOrZero(possible, sum * powerOfTwo(whole));
}

/// x^y of 0 < x <= 2 and 0 < y, as portablePow().
HWY_INLINE Float pow(Float x, Float y) {
    const Double::Tag d;
    const hn::Rebind<float, Double::Tag> df;
    constexpr std::size_t kRoom = HWY_MAX(kLanes, 2);
    HWY_ALIGN float base[kRoom] = {};
    HWY_ALIGN float exponent[kRoom] = {};
    store(x, base);
    store(y, exponent);
    for (std::size_t i = 0; i < lanes(); i += hn::Lanes(d)) {
        const Double b = hn::PromoteTo(d, hn::LoadU(df, base + i));
        const Double e = hn::PromoteTo(d, hn::LoadU(df, exponent + i));
        hn::StoreU(hn::DemoteTo(df, exp2Double(e * log2Double(b)).raw), df, base + i);
    }
    return load(base);
}

HWY_INLINE float pow(float x, float y) { return portablePow(x, y); }

/// sin and cos of |x| <= pi / 4.
HWY_INLINE double sinSeries(double x) {
    const double z = x * x;
    return x * (1 + z * (-1.0 / 6 + z * (1.0 / 120 + z * (-1.0 / 5040 + z * (1.0 / 362880 - z / 39916800)))));
}
HWY_INLINE double cosSeries(double x) {
    const double z = x * x;
    return 1 + z * (-0.5 + z * (1.0 / 24 + z * (-1.0 / 720 + z * (1.0 / 40320 - z / 3628800))));
}

/// atan of 0 <= x <= 1: shifted by atan(k) for the nearest of 9 nodes, so that the series' argument is <
/// 1/16.
HWY_INLINE double atanUnit(double x) {
    static constexpr double kAtanOfEighths[9] = {
        0,
        0.12435499454676143503, // atan(1/8)
        0.24497866312686415417, // atan(2/8)
        0.35877067027057222040, // atan(3/8)
        0.46364760900080611621, // atan(4/8)
        0.55859931534356243597, // atan(5/8)
        0.64350110879328438680, // atan(6/8)
        0.71882999962162450542, // atan(7/8)
        0.78539816339744830962, // atan(8/8)
    };
    const int node = static_cast<int>(std::floor(x * 8 + 0.5));
    const double k = node / 8.0;
    const double d = (x - k) / (1 + x * k);
    const double z = d * d;
    return kAtanOfEighths[node] + d * (1 + z * (-1.0 / 3 + z * (1.0 / 5 - z / 7)));
}

// --- In single precision ---

/// e^x; 0 below -87, as e^87 above; relative error below 2e-7. (Cephes expf)
HWY_INLINE Float fastExp(Float x) {
    const Mask possible = x >= -87.0F;
    x = min(selectOrZero(possible, x), 87.0F);
    const Float whole = floor(x * 1.44269504F + 0.5F);
    const Float rest = x - whole * 0.693359375F - whole * -2.12194440e-4F;
    static constexpr float kSeries[] = {5.0000001201e-1F, 1.6666665459e-1F, 4.1665795894e-2F,
                                        8.3334519073e-3F, 1.3981999507e-3F, 1.9875691500e-4F};
    const Float sum = rest * rest * polynomial(kSeries, rest) + rest + 1.0F;
    return selectOrZero(possible, sum * floatOf(shiftLeft<23>(truncate(whole) + 127)));
}

/// ln x of normal finite x > 0; error below 2e-7 of the larger of 1 and the result. (Cephes logf)
HWY_INLINE Float fastLog(Float x) {
    const Uint bits = bitsOf(x);
    const Float exponent = toFloat(toInt(shiftRight<23>(bits)) - 126);
    const Float mantissa = floatOf((bits & 0x7FFFFFU) | 0x3F000000U);
    const Mask lower = mantissa < 0.707106781F;
    const Float m = mantissa + selectOrZero(lower, mantissa) - 1.0F;
    const Float e = exponent - selectOrZero(lower, Float(1));
    static constexpr float kSeries[] = {3.3333331174e-1F,  -2.4999993993e-1F, 2.0000714765e-1F,
                                        -1.6668057665e-1F, 1.4249322787e-1F,  -1.2420140846e-1F,
                                        1.1676998740e-1F,  -1.1514610310e-1F, 7.0376836292e-2F};
    const Float square = m * m;
    const Float sum = m * square * polynomial(kSeries, m) + e * -2.12194440e-4F - 0.5F * square;
    return m + sum + e * 0.693359375F;
}

/// -ln(1 - u) for 0 <= u < 1, to the last digits of small ones too.
HWY_INLINE Float fastMinusLogOfRest(Float u) {
    static constexpr float kSeries[] = {1,        1.0F / 2, 1.0F / 3, 1.0F / 4,
                                        1.0F / 5, 1.0F / 6, 1.0F / 7, 1.0F / 8};
    const Float low = u * polynomial(kSeries, min(u, 0.125F));
    return select(u < 0.125F, low, -fastLog(max(1.0F - u, 1e-30F)));
}

/// The inverse of sinh.
HWY_INLINE Float fastAsinh(Float x) {
    // Beyond, distances are without meaning.
    const Float size = min(abs(x), 1e15F);
    const Float high = fastLog(size + sqrt(size * size + 1.0F));
    // x - x^3 / 6 + 3 x^5 / 40
    static constexpr float kSeries[] = {1, -1.0F / 6, 3.0F / 40};
    const Float low = size * polynomial(kSeries, size * size);
    return copySign(select(size < 0.05F, low, high), x);
}

/// Error below 3e-7, relative to small results, too. (Cephes atanf)
template <typename F>
HWY_INLINE F fastAtan(F x) {
    const F size = abs(x);
    const auto high = size > 2.414213562F;
    const auto middle = size > 0.4142135624F;
    const F over = select(high, F(-1), size - 1.0F);
    const F under = select(high, size, size + 1.0F);
    const F y = select(middle, over / under, size);
    const F start = selectOrZero(middle, select(high, F(1.570796327F), F(0.785398163F)));
    const F z = y * y;
    static constexpr float kSeries[] = {-3.33329491539e-1F, 1.99777106478e-1F, -1.38776856032e-1F,
                                        8.05374449538e-2F};
    return copySign(start + (polynomial(kSeries, z) * z * y + y), x);
}

/// The angle of (x, y), -pi to pi; 0 of (0, 0). Error below 5e-7, relative to angles below 1.
template <typename F>
HWY_INLINE F fastAtan2(F y, F x) {
    const F along = abs(x), across = abs(y);
    const F acute = fastAtan<F>(min(along, across) / max(max(along, across), F(1e-37F)));
    const F ahead = select(across > along, 1.570796327F - acute, acute);
    return copySign(select(x < 0.0F, 3.141592654F - ahead, ahead), y);
}

/// The tangent of |x| <= pi / 4. (Cephes tanf)
HWY_INLINE Float fastTan(Float x) {
    const Float z = x * x;
    static constexpr float kSeries[] = {3.33331568548e-1F, 1.33387994085e-1F, 5.34112807005e-2F,
                                        2.44301354525e-2F, 3.11992232697e-3F, 9.38540185543e-3F};
    return polynomial(kSeries, z) * z * x + x;
}

template <typename F>
struct UnitCircle {
    F cosine, sine;
};

/// The point at 0 <= turns <= 1; absolute error below 3e-7. An eighth of a turn to each side of an axis by
/// Taylor's series, the rest by symmetry.
template <typename F>
HWY_INLINE UnitCircle<F> unitCircle(F turns) {
    const auto quarter = truncate(turns * 4.0F + 0.5F); // 0..4
    const F a = (turns - toFloat(quarter) * 0.25F) * 6.28318531F;
    const F z = a * a;
    static constexpr float kSine[] = {1, -1.0F / 6, 1.0F / 120, -1.0F / 5040};
    static constexpr float kCosine[] = {1, -0.5F, 1.0F / 24, -1.0F / 720, 1.0F / 40320};
    const F s = a * polynomial(kSine, z);
    const F c = polynomial(kCosine, z);
    const auto odd = (quarter & 1) != 0, half = (quarter & 2) != 0;
    const F x = select(odd, -s, c), y = select(odd, c, s);
    return {select(half, -x, x), select(half, -y, y)};
}

/// The point at |angle| <= pi / 2, in radians; error below 3e-7, of the sine relative to it. (Cephes sinf and
/// cosf of half the angle)
template <typename F>
HWY_INLINE UnitCircle<F> fastCircle(F angle) {
    const F a = 0.5F * angle;
    const F z = a * a;
    static constexpr float kSine[] = {-1.6666654611e-1F, 8.3321608736e-3F, -1.9515295891e-4F};
    static constexpr float kCosine[] = {4.166664568298827e-2F, -1.388731625493765e-3F, 2.443315711809948e-5F};
    const F s = polynomial(kSine, z) * z * a + a;
    const F c = polynomial(kCosine, z) * z * z - 0.5F * z + 1.0F;
    return {(c - s) * (c + s), 2.0F * s * c};
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif
