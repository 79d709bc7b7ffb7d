/// Where a ray meets a triangle, by double: for narrow ones (narrow_noise.h).
#pragma once

#include "rtcore/math/vec.h"

namespace rtcore {

/// One ray as the leaf test wants it: origin and shear in the order of the dominant axis kz.
struct ShearedRay {
    int kx, ky, kz;
    float x, y, z;
    float sx, sy, minusSz;
};

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
