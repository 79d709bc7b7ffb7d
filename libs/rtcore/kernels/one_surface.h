/// Which triangles lie on one surface as far as rays can tell.
///
/// Models have surfaces in one plane, whose distances along a ray differ by rounding alone: which of them is
/// nearest would change from ray to ray. So of all that a ray meets there it hits the triangle of the lowest
/// number, and rays that leave it meet none of the others (docs/decisions/0002).
#pragma once

#include "rtcore/kernels/ray_wave.h"
#include "rtcore/math/vec.h"
#include "rtcore/scene/mesh.h"

#include <cstdint>

namespace rtcore {

/// A triangle as others are held against it.
struct SurfacePlane {
    SurfacePlane(Vec3 a, Vec3 b, Vec3 c);

    Vec3d point;     ///< of it
    Vec3d normal;    ///< unit; zero where the triangle has no area
    float error;     ///< by how much it may be off the plane that was meant, scene units: the rounding of its
                     ///< corners and of what they were computed from
    float clearance; ///< surfaceClearance()
};

/// The point of a surface that a ray meets.
class MetSurface {
  public:
    MetSurface(const SurfacePlane& plane, const Ray& ray);

    /// Whether another triangle that the ray meets lies on the same surface there: its plane has nearly the
    /// same direction, and is no further off than rounding may have moved the two.
    bool has(const SurfacePlane& other) const;
    /// How far off the point that plane is, scene units.
    float gapTo(const SurfacePlane& other) const;

  private:
    SurfacePlane plane_;
    Vec3d point_;
};

} // namespace rtcore
