/// Directions of a hemisphere with the density cos / pi, from points of the unit square (Malley's method): u
/// is the square of the sine of a direction's angle with the pole, v its azimuth.
#pragma once

#include "rtcore/sampling/sample_id.h"
#include "rtcore/simd/portable_math.h"

#include <cmath>
#include <vector>

namespace rtcore {

/// A direction, its azimuth as a rotation.
struct HemispherePoint {
    float u = 0, cosine = 1, sine = 0;
};

inline HemispherePoint hemispherePoint(SquarePoint p) {
    constexpr float kTurn = 6.28318530718F;
    return {p.u, portableCos(kTurn * p.v), portableSin(kTurn * p.v)};
}

/// Replaces `pattern` by `count` >= 1 points of the golden spiral: each has a ring of its own, and azimuths
/// are spread evenly over any few rings. They lie at the inner edges of the rings: all moved outwards by the
/// same 0 <= s < 1 / count they stay in them, and with random s and azimuth they are unbiased together.
inline void setSpiral(int count, std::vector<HemispherePoint>& pattern) {
    pattern.clear();
    for (int k = 0; k < count; ++k) {
        const double turns = 0.61803398874989485 * k;
        const float u = static_cast<float>(k) / static_cast<float>(count);
        pattern.push_back(hemispherePoint({u, static_cast<float>(turns - std::floor(turns))}));
    }
}

} // namespace rtcore
