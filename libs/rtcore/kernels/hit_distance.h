/// The distance of a hit, better than the leaf test gives it.
#pragma once

#include "rtcore/kernels/narrow_noise.h"
#include "rtcore/kernels/ray_wave.h"
#include "rtcore/kernels/rounding.h"
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
/// or `t` is that of a narrow triangle in doubt, precise already (narrow_noise.h), `t` stays.
/// `noise`: narrowNoise() of the triangle.
inline float planeDistance(const Mesh& mesh, std::uint32_t index, float noise, Vec3 origin, Vec3 direction,
                           float t) {
    const Vec3 corners[3] = {mesh.position(index, 0), mesh.position(index, 1), mesh.position(index, 2)};
    const Vec3 a = corners[0] - origin;
    const Vec3 b = corners[1] - origin;
    const Vec3 c = corners[2] - origin;
    const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    const float aa = dot(a, a);
    const float bb = dot(b, b);
    const float cc = dot(c, c);
    const Vec3 nearest = aa <= bb && aa <= cc ? a : bb <= cc ? b : c;
    const float farthest = aa >= bb && aa >= cc ? aa : bb >= cc ? bb : cc;
    const float facing = dot(normal, direction);
    if (noise > 0 && isDoubtful(facing * t, noise)) return t;
    const float exact = dot(normal, nearest) / facing;
    const float apart = exact - t;
    return apart * apart * dot(direction, direction) <= kDistanceError * kDistanceError * farthest ? exact
                                                                                                   : t;
}

/// Hits from here on are exact to about 1e-5 anyway: a 64th of the scene's diagonal, in scene units.
inline float nearLimit(const Box3& bounds) { return length(bounds.hi - bounds.lo) / 64; }

inline bool isNear(const Ray& ray, const Hit& hit, float limit) {
    return hit.t * hit.t * dot(ray.direction, ray.direction) < limit * limit;
}

/// Puts planeDistance() into a hit that is near; it stays inside the ray's range.
inline void refineDistance(const Mesh& mesh, float noise, const Ray& ray, Hit& hit) {
    hit.t = std::clamp(planeDistance(mesh, hit.triangle, noise, ray.origin, ray.direction, hit.t), ray.tMin,
                       ray.tMax);
}

inline void refineDistance(const Mesh& mesh, const Ray& ray, Hit& hit) {
    const float noise = narrowNoise(mesh.position(hit.triangle, 0), mesh.position(hit.triangle, 1),
                                    mesh.position(hit.triangle, 2));
    refineDistance(mesh, noise, ray, hit);
}

} // namespace rtcore
