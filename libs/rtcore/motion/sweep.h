/// Moves an upright capsule until it touches a triangle.
#pragma once

#include "rtcore/motion/separation.h"

#include <span>

namespace rtcore {

struct Sweep {
    double travel = 0; ///< metres that are free
    bool hit = false;
    Vec3d normal;        ///< unit, from what was hit to the capsule
    Vec3d point;         ///< what was hit
    bool onFace = false; ///< the point is inside a triangle, not on an edge
};

/// How far the capsule of `radius` around `core` moves along `direction` (unit), at most `distance`, before
/// it is nearer than `skin` to one of `triangles` that it would touch on the same way, however far; `skin` is
/// measured along the normal, and counts only as far as it was free before. Both sides of a triangle count;
/// starting inside one is a hit at 0 for every direction that leads deeper. Of several that stop it at once
/// it is the one met most directly, whatever the order of the triangles. Conservative advancement (Mirtich
/// 1996) along a line: triangle and capsule are convex, so a step of (gap / approach speed) never passes.
Sweep sweepCapsule(std::span<const SolidTriangle> triangles, const UprightLine& core, double radius,
                   double skin, Vec3d direction, double distance);

} // namespace rtcore
