/// How far an upright line is from a triangle.
#pragma once

#include "rtcore/math/vec.h"
#include "rtcore/motion/nearby_triangles.h"

namespace rtcore {

/// From `foot` upwards; `height` >= 0, at 0 a point. The core of an upright capsule.
struct UprightLine {
    Vec3d foot;
    double height = 0;
};

struct Separation {
    double distance = 0;
    Vec3d normal;        ///< unit, from the triangle to the line; where they meet, a normal of the triangle
    Vec3d onTriangle;    ///< the nearest point
    bool onFace = false; ///< it is inside the triangle, not on an edge
};

/// Exact but for rounding, for triangles of any shape: slivers count as their edges, points as points. The
/// distance is that between a point of the line and one of the triangle.
Separation separate(const UprightLine& line, const SolidTriangle& triangle);

} // namespace rtcore
