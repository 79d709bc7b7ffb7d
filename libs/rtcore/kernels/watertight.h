/// The leaf test of Woop, Benthin and Wald (2013), "Watertight Ray/Triangle Intersection", without its
/// fallback to double: zero edge functions count as inside for both neighbours, so no ray falls between two
/// triangles. Products are not fused (-ffp-contract=off): fused ones differ between processors, and their
/// sign can be wrong.
#pragma once

#include "rtcore/kernels/ray_wave.h"
#include "rtcore/math/vec.h"
#include "rtcore/scene/mesh.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace rtcore {

/// The shear that turns a ray's direction into the z axis.
struct RayShear {
    explicit RayShear(Vec3 direction) {
        const float x = std::fabs(direction.x);
        const float y = std::fabs(direction.y);
        const float z = std::fabs(direction.z);
        kz = x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
        const int kx = kz == 2 ? 0 : kz + 1;
        const int ky = kx == 2 ? 0 : kx + 1;
        sx = direction[kx] / direction[kz];
        sy = direction[ky] / direction[kz];
        sz = 1.0F / direction[kz];
    }
    int kz; ///< the axis along which the direction is longest; x and y are the two that follow it
    float sx, sy, sz;
};

/// What rounding may do to the leaf test's distance, as a share of that of the farthest corner.
inline constexpr float kDistanceError = 0x1p-17F;

/// The distance of a hit once more, from the plane of its triangle: of the three corners the nearest one is
/// taken, and an axis-parallel plane has no rounding but that of its own coordinate. The leaf test's own
/// distance `t` is a mean of the corners', whose error grows with the triangle: too much for a ray that
/// starts beside a large wall. Where the plane is seen so nearly edge-on that its distance is the worse one,
/// `t` stays.
[[gnu::noinline]] inline float planeDistance(const Mesh& mesh, std::uint32_t index, Vec3 origin,
                                             Vec3 direction, float t) {
    const Vec3 corner = mesh.position(index, 0);
    const Vec3 a = corner - origin;
    const Vec3 b = mesh.position(index, 1) - origin;
    const Vec3 c = mesh.position(index, 2) - origin;
    const Vec3 normal = cross(mesh.position(index, 1) - corner, mesh.position(index, 2) - corner);
    const float aa = dot(a, a);
    const float bb = dot(b, b);
    const float cc = dot(c, c);
    const Vec3 nearest = aa <= bb && aa <= cc ? a : bb <= cc ? b : c;
    const float farthest = aa >= bb && aa >= cc ? aa : bb >= cc ? bb : cc;
    const float exact = dot(normal, nearest) / dot(normal, direction);
    const float apart = exact - t;
    return apart * apart * dot(direction, direction) <= kDistanceError * kDistanceError * farthest ? exact
                                                                                                   : t;
}

/// Tests triangle `index` against the ray, whose shear.kz is `Kz`; `hit` holds the closest so far (its t
/// bounds the search) and is replaced when this one is closer, or as close and of lower index. A constant
/// axis spares the choice of nine coordinates: see alongAxis().
template <int Kz>
[[gnu::always_inline]] inline bool testTriangle(const Mesh& mesh, std::uint32_t index, const Ray& ray,
                                                const RayShear& shear, Hit& hit) {
    constexpr int kx = (Kz + 1) % 3;
    constexpr int ky = (Kz + 2) % 3;
    const Triangle& triangle = mesh.triangles[index];
    const Vec3 a = mesh.vertices[triangle.v[0]].position() - ray.origin;
    const Vec3 b = mesh.vertices[triangle.v[1]].position() - ray.origin;
    const Vec3 c = mesh.vertices[triangle.v[2]].position() - ray.origin;
    const float az = a[Kz];
    const float bz = b[Kz];
    const float cz = c[Kz];
    const float ax = a[kx] - shear.sx * az;
    const float ay = a[ky] - shear.sy * az;
    const float bx = b[kx] - shear.sx * bz;
    const float by = b[ky] - shear.sy * bz;
    const float cx = c[kx] - shear.sx * cz;
    const float cy = c[ky] - shear.sy * cz;
    const float u = cx * by - cy * bx;
    const float v = ax * cy - ay * cx;
    const float w = bx * ay - by * ax;
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return false;
    const float det = u + v + w;
    // Seen edge-on; or so nearly that products underflow, and the distance would be noise.
    if (std::fabs(det) < std::numeric_limits<float>::min()) return false;
    const float t = (u * az + v * bz + w * cz) * shear.sz / det;
    const float exact = planeDistance(mesh, index, ray.origin, ray.direction, t);
    // Written so that NaN fails.
    if (!(exact >= ray.tMin && exact <= hit.t)) return false;
    if (exact == hit.t && index >= hit.triangle) return false;
    hit = {exact, index, v / det, w / det};
    return true;
}

/// Calls `work` with the ray's dominant axis as a constant.
template <typename Work>
decltype(auto) alongAxis(int kz, Work&& work) {
    switch (kz) {
    case 0:
        return work(std::integral_constant<int, 0>{});
    case 1:
        return work(std::integral_constant<int, 1>{});
    default:
        return work(std::integral_constant<int, 2>{});
    }
}

} // namespace rtcore
