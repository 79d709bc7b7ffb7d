/// Radiance that filters can spread over a picture without doing harm to all of it.
#pragma once

#include <algorithm>

namespace rtcore {

/// 0 for what is negative or not a number, 1e30 for what is more, infinity included.
inline float usableRadiance(float x) { return x > 0 ? std::min(x, 1e30F) : 0; }

} // namespace rtcore
