#include "rtcore/sections/cut_plane.h"

#include "rtcore/kernels/section_clip.h"
#include "rtcore/scene/camera.h"

namespace rtcore {

CutPlane cutPlaneOf(const SectionPlane& plane, const Box3& bounds, Vec3 sceneUp) {
    const Vec3 unit = normalize(plane.normal);
    const Vec3d normal = normalize(exact(unit)), upwards = exact(upwardsOf(-unit, sceneUp));
    const Vec3d right = normalize(cross(upwards, normal));
    const double further = double{roundingOf(bounds)};
    return {exact(plane.point) + normal * further, right, cross(normal, right), normal};
}

} // namespace rtcore
