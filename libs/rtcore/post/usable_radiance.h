/// Radiance that filters can spread over a picture without doing harm to all of it.
#pragma once

#include <algorithm>

namespace rtcore {

/// 0 for what is negative or not a number, 1e30 for what is more, infinity included.
inline float usableRadiance(float x) { return x > 0 ? std::min(x, 1e30F) : 0; }

/// (1 - share) kept + share spread. Filters dip below zero, by some 1/7000 of a peak.
inline float mixedWith(float kept, float spread, float share) {
    const float added = share * std::max(spread, 0.0F);
    return share < 1 ? kept * (1 - share) + added : added;
}

} // namespace rtcore
