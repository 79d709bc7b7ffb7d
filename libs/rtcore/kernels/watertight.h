/// The leaf test of Woop, Benthin and Wald (2013), "Watertight Ray/Triangle Intersection", without its fallback to
/// double: zero edge functions count as inside for both neighbours, so no ray falls between two triangles.
/// Products are not fused (-ffp-contract=off): fused ones differ between processors, and their sign can be wrong.
#pragma once

#include "rtcore/kernels/ray_wave.h"
#include "rtcore/math/vec.h"
#include "rtcore/scene/mesh.h"

#include <cmath>
#include <cstdint>

namespace rtcore {

/// The shear that turns a ray's direction into the z axis.
struct RayShear {
    explicit RayShear(Vec3 direction) {
        const float x = std::fabs(direction.x);
        const float y = std::fabs(direction.y);
        const float z = std::fabs(direction.z);
        kz = x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
        kx = kz == 2 ? 0 : kz + 1;
        ky = kx == 2 ? 0 : kx + 1;
        sx = direction[kx] / direction[kz];
        sy = direction[ky] / direction[kz];
        sz = 1.0F / direction[kz];
    }
    int kx, ky, kz;
    float sx, sy, sz;
};

/// Tests triangle `index` against the ray; `hit` holds the closest so far (its t bounds the search) and is replaced
/// when this one is closer, or as close and of lower index.
inline bool testTriangle(const Mesh& mesh, std::uint32_t index, Vec3 origin, float tMin, const RayShear& shear,
                         Hit& hit) {
    const Triangle& triangle = mesh.triangles[index];
    const Vec3 a = mesh.vertices[triangle.v[0]].position() - origin;
    const Vec3 b = mesh.vertices[triangle.v[1]].position() - origin;
    const Vec3 c = mesh.vertices[triangle.v[2]].position() - origin;
    const float az = a[shear.kz];
    const float bz = b[shear.kz];
    const float cz = c[shear.kz];
    const float ax = a[shear.kx] - shear.sx * az;
    const float ay = a[shear.ky] - shear.sy * az;
    const float bx = b[shear.kx] - shear.sx * bz;
    const float by = b[shear.ky] - shear.sy * bz;
    const float cx = c[shear.kx] - shear.sx * cz;
    const float cy = c[shear.ky] - shear.sy * cz;
    const float u = cx * by - cy * bx;
    const float v = ax * cy - ay * cx;
    const float w = bx * ay - by * ax;
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return false;
    const float det = u + v + w;
    if (det == 0) return false;
    const float t = (u * az + v * bz + w * cz) * shear.sz / det;
    // Written so that NaN fails.
    if (!(t >= tMin && t <= hit.t)) return false;
    if (t == hit.t && index >= hit.triangle) return false;
    hit = {t, index, v / det, w / det};
    return true;
}

} // namespace rtcore
