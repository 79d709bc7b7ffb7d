#include "rtcore/motion/cut_surroundings.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

/// The floor's height at the feet, though the triangle itself may end before.
bool carries(const SolidTriangle& t, Vec3d feet, double step, double walkable) {
    const Vec3d normal = cross(t.b - t.a, t.c - t.a);
    if (!(std::fabs(normal.z) >= walkable * length(normal)) || normal.z == 0) return false;
    const double height = t.a.z - ((feet.x - t.a.x) * normal.x + (feet.y - t.a.y) * normal.y) / normal.z;
    return height <= feet.z + step;
}

} // namespace

CutSurroundings::CutSurroundings(std::span<const SectionPlane> planes, std::span<const std::uint8_t> uncut,
                                 const WorldFrame& frame, double further, double walkable)
    : uncut_(uncut.begin(), uncut.end()), walkable_(walkable) {
    for (const SectionPlane& plane : planes) {
        const Vec3d normal = normalize(frame.turn(normalize(plane.normal)));
        halves_.push_back(
            {normal, dot(normal, frame.toMetres(plane.point)) + further * frame.metresPerUnit()});
    }
}

void CutSurroundings::cut(const SolidTriangle& triangle, Vec3d feet, double step,
                          std::vector<SolidTriangle>& left) const {
    const auto isKept = [&](Vec3d p) {
        return std::ranges::all_of(halves_, [p](const Half& half) { return half.above(p) <= 0; });
    };
    const bool whole = isKept(triangle.a) && isKept(triangle.b) && isKept(triangle.c);
    if (whole || isUncut(triangle) || carries(triangle, feet, step, walkable_))
        return left.push_back(triangle);
    std::vector<Vec3d> corners{triangle.a, triangle.b, triangle.c}, next;
    for (const Half& half : halves_) {
        next.clear();
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vec3d p = corners[i], q = corners[(i + 1) % corners.size()];
            const double above = half.above(p), beyond = half.above(q);
            if (above <= 0) next.push_back(p);
            if ((above <= 0) != (beyond <= 0)) next.push_back(p + (q - p) * (above / (above - beyond)));
        }
        corners.swap(next);
    }
    for (std::size_t i = 2; i < corners.size(); ++i)
        left.push_back(solidTriangle(corners[0], corners[i - 1], corners[i]));
}

std::pair<double, double> CutSurroundings::kept(Vec3d a, Vec3d b) const {
    double from = 0, to = 1;
    for (const Half& half : halves_) {
        const double above = half.above(a), beyond = half.above(b);
        if (above <= 0 && beyond <= 0) continue;
        if (above > 0 && beyond > 0) return {1, 0};
        const double at = above / (above - beyond);
        above > 0 ? from = std::max(from, at) : to = std::min(to, at);
    }
    return {from, to};
}

} // namespace rtcore
