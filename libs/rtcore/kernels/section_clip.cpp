#include "rtcore/kernels/section_clip.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rtcore {

namespace {

float largestOf(const Box3& bounds) {
    float largest = 0;
    for (const Vec3 corner : {bounds.lo, bounds.hi})
        for (int a = 0; a < 3; ++a) largest = std::max(largest, std::fabs(corner[a]));
    return largest;
}

} // namespace

float roundingOf(const Box3& bounds) {
    constexpr float kRounding = 2e-6F; // of the largest coordinate
    return bounds.empty() ? 0 : kRounding * largestOf(bounds);
}

SectionClip::SectionClip(const SectionPlanes& sections, const Box3& bounds) {
    if (bounds.empty()) return;
    const float rounding = roundingOf(bounds);
    for (const SectionPlane& plane : sections.planes) {
        const Vec3 normal = normalize(plane.normal);
        const float offset = dot(normal, plane.point) + rounding;
        if (dot(normal, farthestCorner(bounds, normal)) > offset) halves_.push_back({normal, offset});
    }
}

bool SectionClip::removes(Vec3 point) const {
    return std::ranges::any_of(halves_,
                               [&](const HalfSpace& half) { return dot(half.normal, point) > half.offset; });
}

void SectionClip::clip(const Ray& ray, float& tMin, float& tMax) const {
    for (const HalfSpace& half : halves_)
        clipInterval(dot(half.normal, ray.direction), half.offset - dot(half.normal, ray.origin), tMin, tMax);
}

} // namespace rtcore
