/// Triangles so long and narrow that single precision cannot tell where a ray meets them.
///
/// The leaf test (watertight.h) takes the mean of the corners' distances, weighted by the edge functions u,
/// v, w. These are differences of products of the corners' positions across the ray; divided by their small
/// sum det, their roundings grow by the length of a triangle over its width. So a long narrow one would be
/// hit by rays that leave it, and be found or not as the cells of a tree happen to lie. Whether a ray meets a
/// triangle is decided by the leaf test alone; where it meets a narrow one, double says if in doubt.
#pragma once

#include "rtcore/accel/float4.h"
#include "rtcore/math/vec.h"

#include <cmath>

namespace rtcore {

/// The largest rounding error of the leaf test's sum of weighted distances, the distance times det, for rays
/// that meet the triangle near their origin. 0 for common triangles: surfaceClearance(), by which rays start
/// off them, is more. Infinity for those so narrow that it matters at any distance. The same bits everywhere.
float narrowNoise(Vec3 a, Vec3 b, Vec3 c);

/// True for most common triangles and for no narrow one, and known sooner. Positions must be finite; the
/// fourth numbers mean nothing.
bool isSurelyCommon(Float4 a, Float4 b, Float4 c);

/// Whether a narrow triangle that is met may in truth lie on the other side of the ray's origin: `sum` is
/// that of the weighted distances.
inline bool isDoubtful(float sum, float noise) { return !(std::fabs(sum) >= noise); } // NaN is

} // namespace rtcore
