#include "rtcore/kernels/precise_hit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rtcore {

namespace {

/// A corner as the ray sees it: x and y across the ray, z along the dominant axis; origin minus corner.
Vec3d shearedCorner(const ShearedRay& ray, Vec3 corner) {
    const auto offset = [&](float origin, int axis) { return double{origin} - corner[axis]; };
    const double z = offset(ray.z, ray.kz);
    return {offset(ray.x, ray.kx) - ray.sx * z, offset(ray.y, ray.ky) - ray.sy * z, z};
}

/// Weights of the corners, and their sum.
struct Weights {
    double of[3];
    double sum;
};

/// The point of the three edges that is nearest to the ray, seen along it.
Weights nearestOfEdges(const Vec3d (&p)[3]) {
    Weights nearest{};
    double min = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const double x = p[j].x - p[i].x;
        const double y = p[j].y - p[i].y;
        const double squared = x * x + y * y;
        const double along = -(p[i].x * x + p[i].y * y);
        const double fraction = squared > 0 ? std::clamp(along / squared, 0.0, 1.0) : 0;
        const double apartX = p[i].x + fraction * x;
        const double apartY = p[i].y + fraction * y;
        const double apart = apartX * apartX + apartY * apartY;
        if (!(apart < min)) continue;
        min = apart;
        nearest = {{0, 0, 0}, 1};
        nearest.of[i] = 1 - fraction;
        nearest.of[j] = fraction;
    }
    return nearest;
}

Weights weightsOf(const Vec3d (&p)[3]) {
    const auto edge = [](Vec3d from, Vec3d to) { return from.x * to.y - from.y * to.x; };
    const double u = edge(p[2], p[1]);
    const double v = edge(p[0], p[2]);
    const double w = edge(p[1], p[0]);
    const double det = u + v + w;
    const bool inside = (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
    return inside && det != 0 ? Weights{{u, v, w}, det} : nearestOfEdges(p);
}

} // namespace

PreciseHit preciseHit(const ShearedRay& ray, Vec3 a, Vec3 b, Vec3 c) {
    const Vec3d p[3] = {shearedCorner(ray, a), shearedCorner(ray, b), shearedCorner(ray, c)};
    const Weights weights = weightsOf(p);
    const double z = weights.of[0] * p[0].z + weights.of[1] * p[1].z + weights.of[2] * p[2].z;
    const auto t = static_cast<float>(z / weights.sum * ray.minusSz);
    return {std::isfinite(t) ? t : std::numeric_limits<float>::quiet_NaN(),
            static_cast<float>(weights.of[1] / weights.sum), static_cast<float>(weights.of[2] / weights.sum)};
}

} // namespace rtcore
