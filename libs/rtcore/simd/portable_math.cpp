#include "rtcore/simd/portable_math.h"

#include "rtcore/simd/functions-inl.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace rtcore {

namespace {

namespace plain = HWY_NAMESPACE;

constexpr double kInvLn2 = 1.44269504088896340736;
constexpr double kPi = std::numbers::pi;

double log2Double(float x) { return plain::log2Double(static_cast<double>(x)); }

double exp2Double(double x) {
    if (x > 129) return std::numeric_limits<double>::infinity();
    return plain::exp2Double(x);
}

/// The sine of `rest` and `quadrant` quarters of a turn.
double sinOfRest(double rest, double quadrant, int shift) {
    const auto which = (static_cast<std::int64_t>(quadrant) + shift) & 3;
    const double value = (which & 1) != 0 ? plain::cosSeries(rest) : plain::sinSeries(rest);
    return which >= 2 ? -value : value;
}

double sinQuadrant(double x, int shift) {
    const double quadrant = std::floor(x / (kPi / 2) + 0.5);
    return sinOfRest(x - quadrant * (kPi / 2), quadrant, shift);
}

double sinOfDegrees(double degrees, int shift) {
    const double quadrant = std::floor(degrees / 90 + 0.5);
    return sinOfRest((degrees - quadrant * 90) * (kPi / 180), quadrant, shift);
}

double atan2Double(double y, double x) {
    const double ax = std::fabs(x);
    const double ay = std::fabs(y);
    // Written so that NaN fails: an index follows from the ratio.
    if (!(ax + ay > 0 && std::isfinite(ax + ay))) return 0;
    double angle = ay <= ax ? plain::atanUnit(ay / ax) : kPi / 2 - plain::atanUnit(ax / ay);
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

double portableSinOfDegrees(double degrees) { return sinOfDegrees(degrees, 0); }
double portableCosOfDegrees(double degrees) { return sinOfDegrees(degrees, 1); }

float portableAtan2(float y, float x) { return static_cast<float>(atan2Double(y, x)); }

float portableAcos(float x) {
    const double c = x < -1 ? -1 : x > 1 ? 1 : static_cast<double>(x);
    // sqrt is exact in IEEE arithmetic, so it is portable.
    return static_cast<float>(atan2Double(std::sqrt((1 - c) * (1 + c)), c));
}

} // namespace rtcore
