/// Hits whose distance single precision cannot tell: which those are, and where they lie by double.
///
/// The leaf test (watertight.h) takes the mean of the corners' distances, weighted by the edge functions u,
/// v, w. These are differences of products of the corners' places across the ray; divided by their small sum
/// det, their roundings grow by the length of a triangle over its width, as it is seen. So a long narrow one
/// would be hit by rays that leave it, and be found or not as the cells of a tree happen to lie. Whether a
/// ray meets a triangle is decided by the leaf test alone; here it is only decided where.
#pragma once

#include "rtcore/math/box.h"
#include "rtcore/math/ray_offset.h"
#include "rtcore/math/vec.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

/// One ray as the leaf test wants it: origin and shear in the order of the dominant axis kz.
struct ShearedRay {
    int kx, ky, kz;
    float x, y, z;
    float sx, sy, minusSz;
};

/// What rounding may do to a distance along the dominant axis so that the hit is found in any tree all the
/// same: half of the least that slackOf() in single_ray.cpp allows for. `bounds` is that of the scene.
inline float distanceReach(const Box3& bounds) {
    const Vec3 size = bounds.hi - bounds.lo;
    return (size.x + size.y + size.z) * 0x1p-15F;
}

/// A bound on the rounding of the leaf test's sum u az + v bz + w cz (the distance times det), for rays of
/// each dominant axis that meet the triangle (a, b, c) near their origin; and of that part of it anywhere
/// which grows with length over width. `normal` is as long as twice the area.
///
/// With e the lengths of the triangle's box, l the longest of them, e2 that along the dominant axis and 2^-24
/// for a rounding: a place across the ray is at most the sum of e2 and another, so that an edge function's
/// two products err by 2 (e0 + e2) (e1 + e2), and all three functions, weighted by what lies between the
/// corners and the hit, by twice e2 of that; corners move by 4 l across the ray and 1 along it.
inline Vec3 distanceNoise(Vec3 a, Vec3 b, Vec3 c, Vec3 normal) {
    const auto range = [](float x, float y, float z) {
        return std::max(x, std::max(y, z)) - std::min(x, std::min(y, z));
    };
    const Vec3 e{range(a.x, b.x, c.x), range(a.y, b.y, c.y), range(a.z, b.z, c.z)};
    const float longest = std::max(e.x, std::max(e.y, e.z));
    const float across = std::fabs(normal.x) + std::fabs(normal.y) + std::fabs(normal.z);
    const float all = e.x + e.y + e.z;
    const float least = e.x * e.y * e.z + 2 * longest * across;
    return Vec3{least + e.x * e.x * all, least + e.y * e.y * all, least + e.z * e.z * all} * 0x1p-22F;
}

inline float largest(Vec3 v) { return std::max(v.x, std::max(v.y, v.z)); }

/// What the leaf test has to know of a triangle: the largest of its distanceNoise(), negative where a ray may
/// start off the triangle by half of surfaceClearance() and be on the wrong side of it by this rounding.
inline float noiseOfTriangle(Vec3 a, Vec3 b, Vec3 c) {
    const Vec3 normal = cross(b - a, c - a);
    const float noise = largest(distanceNoise(a, b, c, normal));
    const float twiceArea = length(normal);
    const float clearance = surfaceClearance(a, b, c, normal * (1 / twiceArea));
    return 2 * noise <= clearance * twiceArea ? noise : -noise;
}

/// Whether rounding decides if a triangle that is met at `t` lies before or behind the origin, or moves it by
/// more than `reach`. det and minusSz as in the leaf test.
inline bool isDoubtful(float t, float det, float minusSz, float noise, float reach) {
    const float scale = std::fabs(minusSz);
    return !(std::fabs(det) * std::min(t, reach * scale) >= std::fabs(noise) * scale);
}

/// Whether a triangle that is met at `t`, behind the origin, may in truth lie before it. `noise` is that
/// along the dominant axis.
inline bool isJustBehind(float t, float det, float minusSz, float noise) {
    return t < 0 && std::fabs(det) * -t < noise * std::fabs(minusSz);
}

/// A triangle just behind the origin is looked for in cells that begin this close, along the dominant axis,
/// and counts as hit up to here: far more than rounding can move one of 1 to 100,000.
inline float behindReach(float reach) { return 16 * reach; }

/// Whether the plane of a triangle lies before the ray's origin, by double.
bool isBefore(const ShearedRay& ray, Vec3 a, Vec3 b, Vec3 c);

/// Where a ray meets a triangle: distance (NaN beyond single precision), and weights of the second and the
/// third corner.
struct PreciseHit {
    float t, v, w;
};

/// By the leaf test's formula in double. A ray that the leaf test lets in by its rounding alone, just beside
/// the triangle, is taken to meet the point of its edges that is the nearest across the ray: there any tree
/// has a cell for it. Corners are three coordinates each. The same bits everywhere.
PreciseHit preciseHit(const ShearedRay& ray, const float* a, const float* b, const float* c);

} // namespace rtcore
