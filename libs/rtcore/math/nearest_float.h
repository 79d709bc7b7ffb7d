/// From double to float, for all doubles.
#pragma once

#include <cmath>
#include <limits>

namespace rtcore {

/// The nearest float; infinity beyond all floats, where a plain conversion is undefined.
inline float nearestFloat(double number) {
    constexpr double kRoundsToInfinity = 0x1.FFFFFFp127, kLargest = std::numeric_limits<float>::max();
    const double size = std::fabs(number);
    if (size <= kLargest || std::isnan(number)) return static_cast<float>(number);
    const float bound =
        size < kRoundsToInfinity ? std::numeric_limits<float>::max() : std::numeric_limits<float>::infinity();
    return number < 0 ? -bound : bound;
}

} // namespace rtcore
