#include "rtcore/motion/sweep.h"

#include <algorithm>

namespace rtcore {

namespace {

constexpr double kTolerance = 1e-4; ///< metres at which two surfaces touch
constexpr double kParallel = 1e-12; ///< approach slower than this is rounding
constexpr int kSteps = 64;          ///< some seven suffice

Box3d sweptBox(const UprightLine& core, double radius, Vec3d move) {
    const Vec3d foot = core.foot, to = foot + move;
    const Box3d box{{std::min(foot.x, to.x), std::min(foot.y, to.y), std::min(foot.z, to.z)},
                    {std::max(foot.x, to.x), std::max(foot.y, to.y), std::max(foot.z, to.z) + core.height}};
    return box.grown(radius + kTolerance);
}

/// Where along `direction` the triangle is touched, or more than `limit`.
struct Touch {
    double at = 0;
    double gap = 0;      ///< left between the surfaces
    double approach = 0; ///< of the two, per metre
    Separation separation;
};

bool touches(const SolidTriangle& triangle, UprightLine core, double radius, Vec3d direction, double limit,
             Touch& touch) {
    const Vec3d start = core.foot;
    double at = 0;
    for (int i = 0; i < kSteps; ++i) {
        core.foot = start + direction * at;
        const Separation s = separate(core, triangle);
        const double approach = -dot(direction, s.normal);
        if (approach <= kParallel) return false;
        const double gap = s.distance - radius;
        touch = {at, gap, approach, s};
        if (gap <= kTolerance) return true;
        at += gap / approach;
        if (at > limit) return false;
    }
    return true; // not settled: where it stands is free all the same
}

} // namespace

Sweep sweepCapsule(std::span<const SolidTriangle> triangles, const UprightLine& core, double radius,
                   double skin, Vec3d direction, double distance) {
    Sweep sweep;
    sweep.travel = distance;
    double first = distance;
    const Box3d box = sweptBox(core, radius, direction * distance);
    for (const SolidTriangle& triangle : triangles) {
        if (!triangle.box.overlaps(box)) continue;
        Touch touch;
        if (!touches(triangle, core, radius, direction, first, touch)) continue;
        if (sweep.hit && touch.at >= first) continue;
        first = touch.at;
        sweep.hit = true;
        sweep.normal = touch.separation.normal;
        sweep.point = touch.separation.onTriangle;
        sweep.onFace = touch.separation.onFace;
        sweep.travel = std::max(0.0, touch.at - (skin - touch.gap) / touch.approach);
    }
    constexpr double kNothing = 1e-7; // so that what rests stays where it is
    if (sweep.travel < kNothing) sweep.travel = 0;
    return sweep;
}

} // namespace rtcore
