#include "rtcore/kernels/precise_hit.h"

#include "rtcore/math/ray_offset.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rtcore {

namespace {

/// A corner as the ray sees it: x and y across the ray, z along the dominant axis; origin minus corner.
struct Place {
    double x, y, z;
};

Place placeOf(const ShearedRay& ray, Vec3 corner) {
    const auto offset = [&](float origin, int axis) { return double{origin} - corner[axis]; };
    const double z = offset(ray.z, ray.kz);
    return {offset(ray.x, ray.kx) - ray.sx * z, offset(ray.y, ray.ky) - ray.sy * z, z};
}

/// Weights of the corners that add up to 1.
struct Weights {
    double of[3];
};

/// The point of the three edges that is nearest to the ray, seen along it.
Weights nearestOfEdges(const Place (&p)[3]) {
    Weights nearest{};
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const double x = p[j].x - p[i].x;
        const double y = p[j].y - p[i].y;
        const double squared = x * x + y * y;
        const double along = -(p[i].x * x + p[i].y * y);
        const double share = squared > 0 ? std::clamp(along / squared, 0.0, 1.0) : 0;
        const double apartX = p[i].x + share * x;
        const double apartY = p[i].y + share * y;
        const double apart = apartX * apartX + apartY * apartY;
        if (!(apart < least)) continue;
        least = apart;
        nearest = {};
        nearest.of[i] = 1 - share;
        nearest.of[j] = share;
    }
    return nearest;
}

Weights weightsOf(const Place (&p)[3]) {
    const auto edge = [](const Place& from, const Place& to) { return from.x * to.y - from.y * to.x; };
    const double u = edge(p[2], p[1]);
    const double v = edge(p[0], p[2]);
    const double w = edge(p[1], p[0]);
    const double det = u + v + w;
    const bool inside = (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
    return inside && det != 0 ? Weights{{u / det, v / det, w / det}} : nearestOfEdges(p);
}

/// From one corner to another.
struct Edge {
    double x, y, z;
};

Edge edge(Vec3 from, Vec3 to) {
    return {double{to.x} - from.x, double{to.y} - from.y, double{to.z} - from.z};
}

double span(double a, double b, double c) { return std::max({a, b, c}) - std::min({a, b, c}); }

} // namespace

/// With x, y, z the sizes of the triangle's box and units of one rounding, 2^-24, for a ray that meets the
/// triangle near its origin: places of the corners across the ray err by at most 2 x + 3 z (z along the
/// dominant axis), distances by z, and the products and sums of distances by 4 z; weighted by the corners'
/// shares that is half as much, and moves the plane by its normal's part of it. Edge functions are of two
/// products of places, which span x + z and y + z: their roundings, weighted by the corners' distances, add
/// up to at most (x + z) (y + z) z, a share of twice the area.
bool isNarrow(Vec3 a, Vec3 b, Vec3 c) {
    constexpr double kRounding = 0x1p-24;
    constexpr double kShare = 0.75; // of the clearance; the rest is for the rounding of where rays start
    const Edge p = edge(a, b);
    const Edge q = edge(a, c);
    const Edge normal{p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
    const double twiceArea = std::sqrt(normal.x * normal.x + normal.y * normal.y + normal.z * normal.z);
    const double x = span(a.x, b.x, c.x);
    const double y = span(a.y, b.y, c.y);
    const double z = span(a.z, b.z, c.z);
    const double nx = std::fabs(normal.x);
    const double ny = std::fabs(normal.y);
    const double nz = std::fabs(normal.z);
    const double places = nx * x + ny * y + nz * z + 3.5 * (nx + ny + nz) * std::max({x, y, z});
    const double products = std::max({(y + x) * (z + x) * x, (x + y) * (z + y) * y, (x + z) * (y + z) * z});
    const Vec3 unit{static_cast<float>(normal.x / twiceArea), static_cast<float>(normal.y / twiceArea),
                    static_cast<float>(normal.z / twiceArea)};
    const double clearance = surfaceClearance(a, b, c, unit);
    // Written so that NaN, of a triangle without area, is narrow.
    return !((places + products) * kRounding <= kShare * clearance * twiceArea);
}

PreciseHit preciseHit(const ShearedRay& ray, Vec3 a, Vec3 b, Vec3 c) {
    const Place p[3] = {placeOf(ray, a), placeOf(ray, b), placeOf(ray, c)};
    const Weights weights = weightsOf(p);
    const double z = weights.of[0] * p[0].z + weights.of[1] * p[1].z + weights.of[2] * p[2].z;
    const auto t = static_cast<float>(z * ray.minusSz);
    return {std::isfinite(t) ? t : std::numeric_limits<float>::quiet_NaN(), static_cast<float>(weights.of[1]),
            static_cast<float>(weights.of[2])};
}

} // namespace rtcore
