/// Flat convex polygons in space.
#pragma once

#include "rtcore/math/vec.h"

#include <vector>

namespace gui {

/// Corners in order; empty: nothing is left of it.
using SpacePolygon = std::vector<rtcore::Vec3d>;

/// The part where dot(normal, p) <= offset; `normal` of any length.
SpacePolygon clipped(const SpacePolygon& polygon, const rtcore::Vec3d& normal, double offset);

/// A square in the plane through `centre`; `normal` of unit length, `half` of a side.
SpacePolygon squareAround(const rtcore::Vec3d& centre, const rtcore::Vec3d& normal, double half);

/// Of its area, or of its corners where that is 0. Not of an empty one.
rtcore::Vec3d centroidOf(const SpacePolygon& polygon);

} // namespace gui
