#include "rtcore/motion/body.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

UprightLine Body::core(Vec3d feet) const { return {lowCentre(feet), std::max(0.0, height_ - 2 * reach())}; }

Box3d Body::box(Vec3d feet) const {
    const UprightLine line = core(feet);
    return Box3d{line.foot, line.foot + Vec3d{0, 0, line.height}}.grown(reach());
}

Sweep Body::sweep(Vec3d feet, Vec3d direction, double distance) const {
    return sweepCapsule(triangles_, core(feet), shape_->radius, shape_->skin, direction, distance);
}

std::optional<Separation> Body::nearest(Vec3d feet) const {
    const UprightLine line = core(feet);
    const Box3d around = box(feet);
    std::optional<Separation> best;
    for (const SolidTriangle& triangle : triangles_) {
        if (!triangle.box.overlaps(around)) continue;
        const Separation s = separate(line, triangle);
        if (s.distance < reach() && (!best || s.distance < best->distance)) best = s;
    }
    return best;
}

bool Body::isFree(Vec3d feet) const {
    const auto found = nearest(feet);
    return !found || found->distance >= shape_->radius;
}

std::vector<Separation> Body::contacts(Vec3d feet) const {
    constexpr double kNearly = 1e-3;
    const UprightLine line = core(feet);
    const Box3d around = box(feet).grown(kNearly);
    std::vector<Separation> all;
    for (const SolidTriangle& triangle : triangles_) {
        if (!triangle.box.overlaps(around)) continue;
        const Separation s = separate(line, triangle);
        if (s.distance <= reach() + kNearly) all.push_back(s);
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const Separation& a, const Separation& b) { return a.distance < b.distance; });
    return all;
}

std::optional<Body::Floor> Body::floorBelow(Vec3d from, double distance) const {
    std::optional<Floor> best;
    for (const SolidTriangle& t : triangles_) {
        if (from.x < t.box.lo.x || from.x > t.box.hi.x || from.y < t.box.lo.y || from.y > t.box.hi.y)
            continue;
        const Vec3d a = t.a - from, b = t.b - from, c = t.c - from;
        const double p = b.x * c.y - b.y * c.x, q = c.x * a.y - c.y * a.x, r = a.x * b.y - a.y * b.x;
        const double sum = p + q + r;
        const bool inside = (p >= 0 && q >= 0 && r >= 0) || (p <= 0 && q <= 0 && r <= 0);
        if (!inside || sum == 0) continue;
        const double z = (p * a.z + q * b.z + r * c.z) / sum;
        if (z > 0 || z < -distance || (best && from.z + z <= best->z)) continue;
        best = Floor{from.z + z, std::fabs(normalize(cross(t.b - t.a, t.c - t.a)).z) >= shape_->walkable};
    }
    return best;
}

} // namespace rtcore
