/// Directions for light from everywhere: patterns of points of the unit square, and how a point becomes a
/// direction of a hemisphere with the density cos/pi (Malley's method).
#pragma once

#include "rtcore/math/portable_math.h"
#include "rtcore/sampling/sample_id.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace rtcore {

/// One direction, before a pattern is shifted: `u` is the square of the sine of its angle with the pole, the
/// others are cosine and sine of its azimuth.
struct HemispherePoint {
    float u = 0, cosine = 1, sine = 0;
};

inline constexpr float kTurn = 6.28318530718F;

/// The azimuth of `v`, 0..1, as a rotation.
inline HemispherePoint hemispherePoint(SquarePoint p) {
    return {p.u, portableCos(kTurn * p.v), portableSin(kTurn * p.v)};
}

/// The k-th of `count` points of the golden spiral: each its own height and azimuth, for every count.
/// However it is shifted on the torus, its points stay evenly spread.
inline SquarePoint spiralPoint(int k, int count) {
    const double turns = 0.61803398874989485 * k;
    return {(static_cast<float>(k) + 0.5F) / static_cast<float>(count),
            static_cast<float>(turns - std::floor(turns))};
}

/// Replaces `pattern` by the spiral of `count` >= 1 points.
inline void setSpiral(int count, std::vector<HemispherePoint>& pattern) {
    pattern.clear();
    for (int k = 0; k < count; ++k) pattern.push_back(hemispherePoint(spiralPoint(k, count)));
}

} // namespace rtcore
