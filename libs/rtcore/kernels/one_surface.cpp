#include "rtcore/kernels/one_surface.h"

#include "rtcore/math/triangle.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

Vec3d inDouble(Vec3 v) { return {v.x, v.y, v.z}; }

/// Eight roundings of the largest coordinates: as many as a node's transform and a rotation may take.
float errorOf(Vec3 a, Vec3 b, Vec3 c, Vec3d normal) {
    constexpr double kRoundings = 0x1p-21;
    double along = 0;
    double largest = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double extent{std::max({std::fabs(a[axis]), std::fabs(b[axis]), std::fabs(c[axis])})};
        along += extent * std::fabs(normal[axis]);
        largest = std::max(largest, extent);
    }
    return static_cast<float>((along + largest) * kRoundings);
}

} // namespace

SurfacePlane::SurfacePlane(Vec3 a, Vec3 b, Vec3 c)
    : point(inDouble(a)), normal(normalize(cross(inDouble(b) - point, inDouble(c) - point))),
      error(errorOf(a, b, c, normal)),
      clearance(surfaceClearance(
          a, b, c,
          {static_cast<float>(normal.x), static_cast<float>(normal.y), static_cast<float>(normal.z)})) {}

MetSurface::MetSurface(const SurfacePlane& plane, const Ray& ray) : plane_(plane) {
    const Vec3d origin = inDouble(ray.origin);
    const Vec3d direction = inDouble(ray.direction);
    const double t = dot(plane.normal, plane.point - origin) / dot(plane.normal, direction);
    point_ = origin + direction * t;
}

float MetSurface::gapTo(const SurfacePlane& other) const {
    return static_cast<float>(std::fabs(dot(other.normal, point_ - other.point)));
}

bool MetSurface::has(const SurfacePlane& other) const {
    constexpr double kTurned =
        1.0 / 16; // sine; small triangles have their corners' rounding in their normals
    const Vec3d across = cross(plane_.normal, other.normal);
    const bool parallel = dot(across, across) <= kTurned * kTurned && dot(other.normal, other.normal) > 0;
    return parallel && gapTo(other) <= std::max(plane_.error, other.error); // NaN is not
}

} // namespace rtcore
