#include "rtcore/plans/line_union.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>

namespace rtcore {

namespace {

/// A line on the straight line that it is part of: `angle` and `offset` name that one, rounded.
struct Stretch {
    std::int64_t angle, offset;
    double from, to; ///< along it
    FlatPoint a, b;
    auto key() const { return std::tuple(angle, offset, from, to); }
};

Stretch stretchOf(const FlatLine& line, double tolerance) {
    constexpr double kAngle = 1e-4;
    FlatPoint a = line.a, b = line.b;
    if (std::tuple(b[0], b[1]) < std::tuple(a[0], a[1])) std::swap(a, b);
    const double dx = b[0] - a[0], dy = b[1] - a[1], length = std::hypot(dx, dy);
    const double right = dx / length, up = dy / length;
    const auto along = [&](const FlatPoint& p) { return right * p[0] + up * p[1]; };
    return {std::llround(std::atan2(up, right) / kAngle),
            std::llround((right * a[1] - up * a[0]) / tolerance),
            along(a),
            along(b),
            a,
            b};
}

} // namespace

std::vector<FlatLine> unionOfLines(const std::vector<FlatLine>& lines, double tolerance) {
    std::vector<Stretch> stretches;
    for (const FlatLine& line : lines)
        if (line.a != line.b) stretches.push_back(stretchOf(line, tolerance));
    std::ranges::sort(stretches, {}, &Stretch::key);
    std::vector<FlatLine> all;
    for (std::size_t i = 0; i < stretches.size();) {
        Stretch whole = stretches[i++];
        for (; i < stretches.size() && stretches[i].angle == whole.angle &&
               stretches[i].offset == whole.offset && stretches[i].from <= whole.to + tolerance;
             ++i) {
            if (stretches[i].to <= whole.to) continue;
            whole.to = stretches[i].to;
            whole.b = stretches[i].b;
        }
        all.push_back({whole.a, whole.b});
    }
    return all;
}

} // namespace rtcore
