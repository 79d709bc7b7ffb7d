/// Triangles so long and narrow that single precision cannot tell where a ray meets them.
///
/// The leaf test (watertight.h) takes the mean of the corners' distances, weighted by the edge functions u,
/// v, w. These are differences of products of the corners' places across the ray; divided by their small sum
/// det, their roundings grow by the length of a triangle over its width. So a long narrow one would be hit by
/// rays that leave it, and be found or not as the cells of a tree happen to lie. Whether a ray meets a
/// triangle is decided by the leaf test alone; for narrow ones only, double says where.
#pragma once

#include "rtcore/math/vec.h"

namespace rtcore {

/// One ray as the leaf test wants it: origin and shear in the order of the dominant axis kz.
struct ShearedRay {
    int kx, ky, kz;
    float x, y, z;
    float sx, sy, minusSz;
};

/// Whether the leaf test's distance may err so much that a ray which starts off the triangle by
/// surfaceClearance() is taken to be nearly on it, or behind. The same bits everywhere.
bool isNarrow(Vec3 a, Vec3 b, Vec3 c);

/// Where a ray meets a triangle: distance (NaN beyond single precision), and weights of the second and the
/// third corner.
struct PreciseHit {
    float t, v, w;
};

/// By the leaf test's formula in double. A ray that the leaf test lets in by its rounding alone, just beside
/// the triangle, is taken to meet the point of its edges that is the nearest across the ray: there any tree
/// has a cell for it. The same bits everywhere.
PreciseHit preciseHit(const ShearedRay& ray, Vec3 a, Vec3 b, Vec3 c);

} // namespace rtcore
