#include "rtcore/sampling/poisson_disc.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rtcore {

namespace {

/// Fraction of the largest distance to begin with: a tighter packing is regular, and shows.
constexpr float kReach = 0.78F;
constexpr float kShrink = 0.99F;
constexpr int kThrows = 200; ///< for each point that lies already, until the radius shrinks

float squareOnTorus(SquarePoint a, SquarePoint b) {
    const float u = std::fabs(a.u - b.u), v = std::fabs(a.v - b.v);
    const float du = std::min(u, 1 - u), dv = std::min(v, 1 - v);
    return du * du + dv * dv;
}

bool fits(SquarePoint dart, const std::vector<SquarePoint>& points, float radius) {
    return std::none_of(points.begin(), points.end(),
                        [&](SquarePoint p) { return squareOnTorus(p, dart) < radius * radius; });
}

/// The same points, row by row: about as many rows as points in each.
void sortByRows(std::vector<SquarePoint>& points) {
    const auto rows = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<float>(points.size()))));
    std::sort(points.begin(), points.end(), [](SquarePoint a, SquarePoint b) { return a.v < b.v; });
    for (std::size_t row = 0; row < rows; ++row) {
        const auto at = [&](std::size_t i) {
            return points.begin() + static_cast<std::ptrdiff_t>(i * points.size() / rows);
        };
        std::sort(at(row), at(row + 1), [](SquarePoint a, SquarePoint b) { return a.u < b.u; });
    }
}

} // namespace

float largestPoissonDistance(int count) {
    return std::sqrt(2 / (std::sqrt(3.0F) * static_cast<float>(count)));
}

std::vector<SquarePoint> poissonDisc(int count) {
    std::vector<SquarePoint> points;
    points.reserve(static_cast<std::size_t>(count));
    float radius = kReach * largestPoissonDistance(count);
    std::uint32_t thrown = 0;
    while (points.size() < static_cast<std::size_t>(count)) {
        bool found = false;
        const std::size_t throws = kThrows * (points.size() + 1);
        for (std::size_t i = 0; i < throws && !found; ++i) {
            const std::uint32_t u = mixBits(++thrown);
            const SquarePoint dart{unitFloat(u), unitFloat(mixBits(u + 0x85EBCA6BU))};
            found = fits(dart, points, radius);
            if (found) points.push_back(dart);
        }
        if (!found) radius *= kShrink;
    }
    sortByRows(points);
    return points;
}

} // namespace rtcore
