/// Makes radiance finite and non-negative, so that one bad pixel does not spoil a whole filtered image.
#pragma once

#include <algorithm>

namespace rtcore {

/// 0 for negative values and NaN; at most 1e30, infinity included.
inline float sanitizeRadiance(float x) { return x > 0 ? std::min(x, 1e30F) : 0; }

/// (1 - fraction) kept + fraction spread. Filters undershoot by some 1/7000 of a peak.
inline float mixedWith(float kept, float spread, float fraction) {
    const float added = fraction * std::max(spread, 0.0F);
    return fraction < 1 ? kept * (1 - fraction) + added : added;
}

} // namespace rtcore
