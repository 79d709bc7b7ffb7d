/// The distance of a hit, better than the leaf test gives it.
#pragma once

#include "rtcore/kernels/precise_hit.h"
#include "rtcore/kernels/ray_wave.h"
#include "rtcore/kernels/rounding.h"
#include "rtcore/kernels/watertight.h"
#include "rtcore/math/box.h"
#include "rtcore/math/vec.h"
#include "rtcore/scene/mesh.h"

#include <algorithm>
#include <cstdint>

namespace rtcore {

/// The distance of a hit once more, from the plane of its triangle: of the three corners the nearest one is
/// taken, and an axis-parallel plane has no rounding but that of its own coordinate. The leaf test's own
/// distance `t` is a mean of the corners', whose error grows with the triangle: too much for a ray that
/// starts beside a large wall. Where the plane is seen so nearly edge-on that its distance is the worse one,
/// or `t` is precise already (precise_hit.h; `reach` as there), `t` stays.
inline float planeDistance(const Mesh& mesh, std::uint32_t index, const Ray& ray, float reach, float t) {
    const Vec3 corners[3] = {mesh.position(index, 0), mesh.position(index, 1), mesh.position(index, 2)};
    const Vec3 a = corners[0] - ray.origin;
    const Vec3 b = corners[1] - ray.origin;
    const Vec3 c = corners[2] - ray.origin;
    const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    const float aa = dot(a, a);
    const float bb = dot(b, b);
    const float cc = dot(c, c);
    const Vec3 nearest = aa <= bb && aa <= cc ? a : bb <= cc ? b : c;
    const float farthest = aa >= bb && aa >= cc ? aa : bb >= cc ? bb : cc;
    const float facing = dot(normal, ray.direction);
    const RayShear shear(ray.direction);
    const float noise = largest(distanceNoise(corners[0], corners[1], corners[2], normal));
    if (isDoubtful(t, facing * shear.minusSz, shear.minusSz, noise, reach)) {
        return preciseHit(shearedRay(ray, shear), &corners[0].x, &corners[1].x, &corners[2].x).t;
    }
    const float exact = dot(normal, nearest) / facing;
    const float apart = exact - t;
    return apart * apart * dot(ray.direction, ray.direction) <= kDistanceError * kDistanceError * farthest
               ? exact
               : t;
}

/// Hits from here on are exact to about 1e-5 anyway: a 64th of the scene's diagonal, in scene units.
inline float nearLimit(const Box3& bounds) { return length(bounds.hi - bounds.lo) / 64; }

inline bool isNear(const Ray& ray, const Hit& hit, float limit) {
    return hit.t * hit.t * dot(ray.direction, ray.direction) < limit * limit;
}

/// Puts planeDistance() into a hit that is near; it stays inside the ray's range.
inline void refineDistance(const Mesh& mesh, const Ray& ray, float reach, Hit& hit) {
    hit.t = std::clamp(planeDistance(mesh, hit.triangle, ray, reach, hit.t), ray.tMin, ray.tMax);
}

} // namespace rtcore
