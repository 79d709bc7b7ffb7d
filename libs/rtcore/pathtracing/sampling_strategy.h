/// The strategies by which paths sample light, and the clamp of indirect light.
#pragma once

#include "rtcore/math/colour.h"

#include <cstdint>

namespace rtcore {

/// How light from area lights, emitters and surroundings is sampled at points that scatter it. All strategies
/// have the same mean; one alone is for tests and comparisons.
enum class SamplingStrategy : std::uint8_t {
    Both, ///< next event and scattered rays, by the power heuristic
    NextEvent,
    ScatteredRays ///< beside it next event of lights that no ray meets
};

/// Scaled down so that the mean of its channels is at most `max`; 0: as it is. (Cycles)
inline Colour clampedTo(float max, Colour c) {
    const float mean = (c.r + c.g + c.b) / 3;
    return max > 0 && mean > max ? c * (max / mean) : c;
}

} // namespace rtcore
