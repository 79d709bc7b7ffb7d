#include "rtcore/motion/slide.h"

#include <cmath>
#include <limits>

namespace rtcore {

namespace {

constexpr int kSweeps = 5;
constexpr double kNothing = 1e-9; ///< metres

/// `move` turned into the plane of the floor, with its heading and length; over an edge it only rises.
Vec3d alongFloor(Vec3d move, const FloorPlane& floor) {
    const double rise = -(floor.normal.x * move.x + floor.normal.y * move.y) / floor.normal.z;
    const Vec3d path{move.x, move.y, rise};
    if (floor.edge) return path;
    const double whole = length(path);
    return whole > 0 ? path * (length(move) / whole) : Vec3d{};
}

/// One straight part of a slide. Returns the fraction of `path` that is left.
double advance(const Body& body, Vec3d path, Slide& slide, Sweep& sweep, MotionTrail* trail) {
    const double whole = length(path);
    const Vec3d direction = path * (1 / whole);
    sweep = body.sweep(slide.feet, direction, whole);
    slide.feet += direction * sweep.travel;
    if (trail != nullptr) trail->push_back(slide.feet);
    return sweep.hit ? 1 - sweep.travel / whole : 0;
}

} // namespace

bool MetPlanes::feasible(Vec3d move) const {
    for (const Vec3d n : normals_) {
        if (dot(move, n) < -kNothing) return false;
    }
    return true;
}

Vec3d MetPlanes::clip(Vec3d move) const {
    if (feasible(move)) return move;
    Vec3d best;
    double nearest = std::numeric_limits<double>::max();
    const auto consider = [&](Vec3d candidate) {
        const Vec3d lost = move - candidate;
        if (dot(lost, lost) >= nearest || !feasible(candidate)) return;
        nearest = dot(lost, lost);
        best = candidate;
    };
    for (const Vec3d n : normals_) consider(move - n * dot(move, n));
    if (nearest < std::numeric_limits<double>::max()) return best;
    for (std::size_t i = 0; i < normals_.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const Vec3d crease = cross(normals_[i], normals_[j]);
            constexpr double kParallel = 1e-3;
            if (length(crease) <= kParallel) continue;
            const Vec3d along = normalize(crease);
            consider(along * dot(move, along));
        }
    }
    return best;
}

Slide slideOnGround(const Body& body, Vec3d feet, Vec3d move, FloorPlane floor, MotionTrail* trail) {
    Slide slide;
    slide.feet = feet;
    Vec3d left = move;
    for (int i = 0; i < kSweeps && length(left) > kNothing; ++i) {
        Sweep sweep;
        slide.rolled = slide.rolled || floor.edge;
        const double fraction = advance(body, alongFloor(left, floor), slide, sweep, trail);
        if (!sweep.hit) break;
        left = left * fraction;
        if (sweep.normal.z >= body.shape().walkable) {
            floor = {sweep.normal, !sweep.onFace};
            continue;
        }
        const Vec3d wall = normalize(horizontal(sweep.normal));
        slide.blocked = sweep;
        slide.blockedMove = left;
        if (wall == Vec3d{}) break;
        slide.met.add(wall);
        left = slide.met.clip(left);
        if (dot(left, move) <= 0) break;
    }
    return slide;
}

Slide slideInAir(const Body& body, Vec3d feet, Vec3d move, MotionTrail* trail) {
    Slide slide;
    slide.feet = feet;
    Vec3d left = move;
    for (int i = 0; i < kSweeps && length(left) > kNothing; ++i) {
        Sweep sweep;
        const double fraction = advance(body, left, slide, sweep, trail);
        if (!sweep.hit) break;
        left = left * fraction;
        slide.met.add(sweep.normal);
        if (sweep.normal.z >= body.shape().walkable) {
            slide.landed = true;
            left.z = 0;
        } else {
            slide.blocked = sweep;
        }
        constexpr double kOverhead = -0.2;
        if (sweep.normal.z < kOverhead) slide.ceiling = true;
        left = slide.met.clip(left);
        if (dot(left, move) <= 0) break;
    }
    return slide;
}

} // namespace rtcore
