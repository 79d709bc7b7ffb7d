/// Rays of an image as a renderer makes them - primary, shadow, diffuse bounce - for the models of the
/// tests.
#pragma once

#include "rtcore/kernels/ray_wave.h"
#include "rtcore/math/triangle.h"
#include "rtcore/scene/mesh.h"
#include "support/random_numbers.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace test {

struct View {
    const char* name;
    const char* file; ///< below the folder of scenes
    rtcore::Vec3 eye, at;
    float verticalFov; ///< degrees
    rtcore::Vec3 light;
};

inline constexpr View kViews[] = {
    {"sibenik", "sibenik/sibenik.ply", {-16, -10, 0}, {10, -9, 0}, 60, {-2, 4, 0}},
    {"sponza", "sponza_crytek/sponza.obj", {-1100, 350, -40}, {800, 350, 0}, 65, {0, 1000, 0}},
    {"dragon", "dragon/dragon.ply", {-0.04F, 0.17F, 0.20F}, {-0.006F, 0.12F, 0}, 45, {-0.3F, 0.5F, 0.4F}},
    {"bunny", "bunny/bunny.obj", {-0.06F, 0.14F, 0.22F}, {-0.02F, 0.105F, 0}, 45, {-0.2F, 0.4F, 0.3F}},
};

inline constexpr float kUnlimited = std::numeric_limits<float>::infinity();

/// One ray for each pixel, not normalised, in tiles of 4x4 pixels. `side` is a multiple of 4.
inline std::vector<rtcore::Ray> primaryRays(const View& view, int side) {
    const rtcore::Vec3 forward = normalize(view.at - view.eye);
    const rtcore::Vec3 right = normalize(cross(forward, {0, 1, 0}));
    const rtcore::Vec3 up = cross(right, forward);
    const float half = std::tan(view.verticalFov * std::acos(-1.0F) / 360);
    std::vector<rtcore::Ray> rays;
    rays.reserve(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
    for (int i = 0; i < side * side; ++i) {
        const int tile = i / 16;
        const int x = tile % (side / 4) * 4 + i % 4;
        const int y = tile / (side / 4) * 4 + i / 4 % 4;
        const float u = (2 * (static_cast<float>(x) + 0.5F) / static_cast<float>(side) - 1) * half;
        const float v = (1 - 2 * (static_cast<float>(y) + 0.5F) / static_cast<float>(side)) * half;
        rays.push_back({view.eye, 0, forward + right * u + up * v, kUnlimited});
    }
    return rays;
}

/// A point that was hit, just off the surface, on the side that the ray came from.
struct SurfacePoint {
    rtcore::Vec3 position, normal;
};

/// One for each ray that hit, in the order of the rays.
inline std::vector<SurfacePoint> surfacePoints(const rtcore::Mesh& mesh, const std::vector<rtcore::Ray>& rays,
                                               const std::vector<rtcore::Hit>& hits) {
    std::vector<SurfacePoint> points;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (hits[i].triangle == rtcore::kNoTriangle) continue;
        rtcore::Vec3 normal = normalize(mesh.geometricNormal(hits[i].triangle));
        if (dot(normal, rays[i].direction) > 0) normal = -normal;
        const rtcore::Vec3 a = mesh.position(hits[i].triangle, 0);
        const rtcore::Vec3 b = mesh.position(hits[i].triangle, 1);
        const rtcore::Vec3 c = mesh.position(hits[i].triangle, 2);
        const rtcore::Vec3 position = a * (1 - hits[i].u - hits[i].v) + b * hits[i].u + c * hits[i].v;
        points.push_back({position + normal * rtcore::surfaceClearance(a, b, c, normal), normal});
    }
    return points;
}

/// From each point to the light; t = 1 is the light itself.
inline std::vector<rtcore::Ray> shadowRays(const std::vector<SurfacePoint>& points, rtcore::Vec3 light) {
    std::vector<rtcore::Ray> rays;
    for (const SurfacePoint& p : points) rays.push_back({p.position, 0, light - p.position, 1});
    return rays;
}

/// From each point in a random direction, distributed by the cosine with the normal.
inline std::vector<rtcore::Ray> diffuseRays(const std::vector<SurfacePoint>& points, std::uint64_t seed) {
    Random random(seed);
    std::vector<rtcore::Ray> rays;
    for (const SurfacePoint& p : points) {
        rtcore::Vec3 direction = p.normal + random.unitVector() * 0.999F;
        rays.push_back({p.position, 0, normalize(direction), kUnlimited});
    }
    return rays;
}

} // namespace test
