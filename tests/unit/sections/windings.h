/// How often a loop winds around a point.
#pragma once

#include "rtcore/sections/cut_plane.h"

#include <cstddef>

namespace test {

/// By a ray to the right: anticlockwise once, where y grows upwards.
inline int windings(const rtcore::FlatLoop& loop, rtcore::FlatPoint p) {
    int count = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const rtcore::FlatPoint &a = loop[i], &b = loop[(i + 1) % loop.size()];
        if ((a[1] <= p[1]) == (b[1] <= p[1])) continue;
        const double x = a[0] + (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]);
        if (x > p[0]) count += a[1] < b[1] ? 1 : -1;
    }
    return count;
}

} // namespace test
