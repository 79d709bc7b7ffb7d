#include "rtcore/math/portable_math.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace rtcore {

namespace {

constexpr double kLn2 = 0.69314718055994530942;
constexpr double kInvLn2 = 1.44269504088896340736;
constexpr double kPi = 3.14159265358979323846;

/// ln(m) for m in [sqrt(1/2), sqrt(2)] by 2 atanh(s), s = (m-1)/(m+1), |s| < 0.1716.
double logOfMantissa(double m) {
    const double s = (m - 1) / (m + 1);
    const double z = s * s;
    return 2 * s * (1 + z * (1.0 / 3 + z * (1.0 / 5 + z * (1.0 / 7 + z * (1.0 / 9 + z * (1.0 / 11))))));
}

double log2Double(float x) {
    const auto bits = std::bit_cast<std::uint64_t>(static_cast<double>(x));
    int exponent = static_cast<int>(bits >> 52) - 1023;
    double mantissa = std::bit_cast<double>((bits & 0xFFFFFFFFFFFFFULL) | 0x3FF0000000000000ULL);
    if (mantissa > 1.41421356237309505) {
        mantissa *= 0.5;
        ++exponent;
    }
    return exponent + logOfMantissa(mantissa) * kInvLn2;
}

/// 2^x: 2^round(x) by exponent bits, e^(fraction ln 2) by its series, |fraction ln 2| < 0.347.
double exp2Double(double x) {
    if (!(x >= -150)) return 0;
    if (x > 129) return std::numeric_limits<double>::infinity();
    const double whole = std::floor(x + 0.5);
    const double f = (x - whole) * kLn2;
    const double series =
        1 +
        f * (1 + f * (1.0 / 2 +
                      f * (1.0 / 6 + f * (1.0 / 24 + f * (1.0 / 120 +
                                                          f * (1.0 / 720 + f * (1.0 / 5040 + f / 40320)))))));
    const auto exponentBits = static_cast<std::uint64_t>(static_cast<std::int64_t>(whole) + 1023) << 52;
    return series * std::bit_cast<double>(exponentBits);
}

/// sin and cos of |x| <= pi/4.
double sinSeries(double x) {
    const double z = x * x;
    return x * (1 + z * (-1.0 / 6 + z * (1.0 / 120 + z * (-1.0 / 5040 + z * (1.0 / 362880 - z / 39916800)))));
}
double cosSeries(double x) {
    const double z = x * x;
    return 1 + z * (-0.5 + z * (1.0 / 24 + z * (-1.0 / 720 + z * (1.0 / 40320 - z / 3628800))));
}

double sinQuadrant(double x, int shift) {
    const double quadrant = std::floor(x / (kPi / 2) + 0.5);
    const double rest = x - quadrant * (kPi / 2);
    const auto which = (static_cast<std::int64_t>(quadrant) + shift) & 3;
    const double value = (which & 1) != 0 ? cosSeries(rest) : sinSeries(rest);
    return which >= 2 ? -value : value;
}

/// atan of 0 <= x <= 1: shifted by atan(k) for the nearest of 9 nodes, so that the series' argument is <
/// 1/16.
double atanUnit(double x) {
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

double atan2Double(double y, double x) {
    const double ax = std::fabs(x);
    const double ay = std::fabs(y);
    // Written so that NaN fails: an index follows from the ratio.
    if (!(ax + ay > 0 && std::isfinite(ax + ay))) return 0;
    double angle = ay <= ax ? atanUnit(ay / ax) : kPi / 2 - atanUnit(ax / ay);
    if (x < 0) angle = kPi - angle;
    return y < 0 ? -angle : angle;
}

} // namespace

float portableLog2(float x) {
    if (!(x > 0)) return -std::numeric_limits<float>::infinity();
    return static_cast<float>(log2Double(x));
}

float portableExp2(float x) { return static_cast<float>(exp2Double(x)); }

float portableExp(float x) { return static_cast<float>(exp2Double(x * kInvLn2)); }

float portablePow(float x, float y) {
    if (y == 0) return 1;
    if (!(x > 0)) return 0;
    return static_cast<float>(exp2Double(y * log2Double(x)));
}

float portableSin(float x) { return static_cast<float>(sinQuadrant(x, 0)); }
float portableCos(float x) { return static_cast<float>(sinQuadrant(x, 1)); }

float portableAtan2(float y, float x) { return static_cast<float>(atan2Double(y, x)); }

float portableAcos(float x) {
    const double c = x < -1 ? -1 : x > 1 ? 1 : static_cast<double>(x);
    // sqrt is exact in IEEE arithmetic, so it is portable.
    return static_cast<float>(atan2Double(std::sqrt((1 - c) * (1 + c)), c));
}

} // namespace rtcore
