/// The leaf test of Woop, Benthin and Wald (2013), "Watertight Ray/Triangle Intersection", without its
/// fallback to double: zero edge functions count as inside for both neighbours, so no ray falls between two
/// triangles. Products are not fused (-ffp-contract=off): fused ones differ between processors, and their
/// sign can be wrong.
#pragma once

#include "rtcore/kernels/narrow_noise.h"
#include "rtcore/kernels/precise_hit.h"
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
        minusSz = -1.0F / direction[kz];
    }
    int kz; ///< the axis along which the direction is longest; x and y are the two that follow it
    float sx, sy, minusSz;
};

inline ShearedRay shearedRay(const Ray& ray, const RayShear& shear) {
    const int kx = (shear.kz + 1) % 3;
    const int ky = (shear.kz + 2) % 3;
    return {kx,       ky,       shear.kz,     ray.origin[kx], ray.origin[ky], ray.origin[shear.kz],
            shear.sx, shear.sy, shear.minusSz};
}

/// A triangle as the test wants it.
struct TriangleCorners {
    const Vertex &a, &b, &c;
    std::uint32_t index;
};

/// Tests a triangle against the ray, whose shear.kz is `Kz`; `hit` holds the closest so far (its t bounds the
/// search) and is replaced when this one is closer, or as close and of lower index. A constant axis spares
/// the choice of nine coordinates: see alongAxis(). `noiseOf` gives the triangle's narrowNoise().
template <int Kz, typename NoiseOf>
[[gnu::always_inline]] inline bool testTriangle(const TriangleCorners& corners, const Ray& ray,
                                                const RayShear& shear, Hit& hit, const NoiseOf& noiseOf) {
    constexpr int kx = (Kz + 1) % 3;
    constexpr int ky = (Kz + 2) % 3;
    // Origin minus corner, as leaf_test-inl.h has it: the other way round only the signs of zeros differ.
    const Vec3 a = ray.origin - corners.a.position();
    const Vec3 b = ray.origin - corners.b.position();
    const Vec3 c = ray.origin - corners.c.position();
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
    const Vec3 p = corners.a.position();
    const Vec3 q = corners.b.position();
    const Vec3 r = corners.c.position();
    const float sum = u * az + v * bz + w * cz;
    const float noise = noiseOf(corners);
    const PreciseHit at = noise > 0 && isDoubtful(sum, noise)
                              ? preciseHit(shearedRay(ray, shear), p, q, r)
                              : PreciseHit{sum * shear.minusSz / det, v / det, w / det};
    // Written so that NaN fails.
    if (!(at.t >= ray.tMin && at.t <= hit.t)) return false;
    if (at.t == hit.t && corners.index >= hit.triangle) return false;
    hit = {at.t, corners.index, at.v, at.w};
    return true;
}

/// narrowNoise() of any triangle.
inline float noiseByCorners(const TriangleCorners& corners) {
    return narrowNoise(corners.a.position(), corners.b.position(), corners.c.position());
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
