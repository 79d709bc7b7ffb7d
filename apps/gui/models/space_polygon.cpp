#include "gui/models/space_polygon.h"

#include <cmath>
#include <cstddef>

namespace gui {

using rtcore::Vec3d;

SpacePolygon clipped(const SpacePolygon& polygon, const Vec3d& normal, double offset) {
    SpacePolygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3d &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double a = dot(normal, p) - offset, b = dot(normal, q) - offset;
        if (a <= 0) kept.push_back(p);
        if ((a < 0 && b > 0) || (a > 0 && b < 0)) kept.push_back(p + (q - p) * (a / (a - b)));
    }
    return kept;
}

SpacePolygon squareAround(const Vec3d& centre, const Vec3d& normal, double half) {
    const Vec3d other = std::fabs(normal.x) < 0.7 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
    const Vec3d u = normalize(cross(normal, other)) * half, v = cross(normal, u);
    return {centre - u - v, centre + u - v, centre + u + v, centre - u + v};
}

Vec3d centroidOf(const SpacePolygon& polygon) {
    Vec3d sum{}, corners{};
    double area = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3d &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double twice = length(cross(p - polygon[0], q - polygon[0]));
        sum = sum + (p + q - polygon[0] * 2.0) * (twice / 3);
        area += twice;
        corners = corners + (p - polygon[0]);
    }
    const Vec3d off = area > 0 ? sum * (1 / area) : corners * (1.0 / static_cast<double>(polygon.size()));
    return polygon[0] + off;
}

} // namespace gui
