#include "rtcore/io/text/cosine.h"

#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <numbers>

namespace rtcore {

namespace {

/// sin of |x| <= pi / 2 by its series; the first term left out is below 1e-20.
double sine(double x) {
    const double square = x * x;
    double term = x, sum = x;
    for (int n = 2; n < 24; n += 2) {
        term *= -square / (n * (n + 1.0));
        sum += term;
    }
    return sum;
}

double roundedToDigits(double value, int digits) {
    const std::string text = fmt::format("{:.{}e}", value, digits - 1);
    double rounded = value;
    std::from_chars(text.data(), text.data() + text.size(), rounded);
    return rounded;
}

/// The angle of 0..180 degrees with the fewest digits whose `function`, which rises or falls with it, is
/// that.
template <bool rises>
double degreesOf(float wanted, float (*function)(double)) {
    double low = 0, high = 180;
    for (int step = 0; step < 80; ++step) { // bisection
        const double middle = (low + high) / 2;
        const float found = function(middle);
        if (found == wanted) {
            low = high = middle;
            break;
        }
        ((found < wanted) == rises ? low : high) = middle;
    }
    const double angle = (low + high) / 2;
    for (int digits = 1; digits < 17; ++digits) {
        const double rounded = roundedToDigits(angle, digits);
        if (rounded >= 0 && rounded <= 180 && function(rounded) == wanted) return rounded;
    }
    return angle;
}

} // namespace

float cosineOfDegrees(double degrees) {
    constexpr double radians = std::numbers::pi / 180.0;
    return static_cast<float>(sine((90.0 - degrees) * radians));
}

double degreesOfCosine(float cosine) {
    if (cosine >= 1) return 0;
    return degreesOf<false>(cosine, cosineOfDegrees);
}

float sineOfHalf(double degrees) {
    constexpr double radians = std::numbers::pi / 180.0;
    return static_cast<float>(sine(degrees / 2 * radians));
}

double degreesOfHalfSine(float value) {
    if (value <= 0) return 0;
    if (value >= 1) return 180;
    return degreesOf<true>(value, sineOfHalf);
}

} // namespace rtcore
