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

/// How far the capsule of `radius` around `core` moves along `direction` (unit) before it touches one of
/// `triangles`, at most `distance`. After a hit it stays `skin` away from what it hit, measured along the
/// normal, as far as it was before. Both sides of a triangle count; starting inside one is a hit at 0 for
/// every direction that leads deeper. Conservative advancement (Mirtich 1996) along a line: triangle and
/// capsule are convex, so a step of (gap / approach speed) never passes.
Sweep sweepCapsule(std::span<const SolidTriangle> triangles, const UprightLine& core, double radius,
                   double skin, Vec3d direction, double distance);

} // namespace rtcore
