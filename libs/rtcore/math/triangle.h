/// Properties of a triangle that follow from its corners. The formulas are in triangle-inl.h.
#pragma once

#include "rtcore/math/vec.h"

namespace rtcore {

/// The sum of the cosines between a face and the normals of its corners, below which the normals tell that
/// the order of the corners is wrong: a third of it is a mean of 14 degrees behind the face.
inline constexpr float kNormalsBehind = -0.75F;

/// How far off its triangle (a, b, c), along the unit normal, a ray has to start that must not hit it. A
/// point on the triangle and the test of a ray against it are rounded in proportion to the corners, even
/// where the point itself is near the origin; so the step is 64 roundings of their largest coordinates'
/// contribution along the normal, and 16 of the largest of all for rays that graze. It suits scenes of any
/// size. (Waechter and Binder 2019, "A Fast and Robust Method for Avoiding Self-Intersection", steps by the
/// point alone: too little where a large triangle passes near the origin.)
float surfaceClearance(Vec3 a, Vec3 b, Vec3 c, Vec3 normal);

} // namespace rtcore
