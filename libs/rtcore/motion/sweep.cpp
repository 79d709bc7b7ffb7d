#include "rtcore/motion/sweep.h"

#include <algorithm>

namespace rtcore {

namespace {

constexpr double kTolerance = 1e-4; ///< metres at which two surfaces touch
constexpr double kSlack = 1e-5;     ///< metres of the skin that a move may use up
constexpr double kParallel = 1e-12; ///< approach slower than this is rounding
constexpr int kSteps = 64;          ///< some seven suffice

Box3d sweptBox(const UprightLine& core, double reach, Vec3d move) {
    const Vec3d foot = core.foot, to = foot + move;
    const Box3d box{{std::min(foot.x, to.x), std::min(foot.y, to.y), std::min(foot.z, to.z)},
                    {std::max(foot.x, to.x), std::max(foot.y, to.y), std::max(foot.z, to.z) + core.height}};
    return box.grown(reach + kTolerance);
}

/// A capsule that moves past or against one triangle. The gap between them is a convex function of the way: a
/// step of (gap / approach) never goes too far, and the slope at one place bounds the gap everywhere else.
class Approach {
  public:
    Approach(const SolidTriangle& triangle, const UprightLine& core, double radius, Vec3d direction)
        : triangle_(triangle), line_(core), start_(core.foot), direction_(direction), radius_(radius) {
        moveTo(0);
    }

    double at() const { return at_; }
    double gap() const { return gap_; }
    double speed() const { return speed_; } ///< by which the gap closes, per metre of the way
    const Separation& separation() const { return separation_; }

    void moveTo(double at) {
        at_ = at;
        line_.foot = start_ + direction_ * at;
        separation_ = separate(line_, triangle_);
        gap_ = separation_.distance - radius_;
        speed_ = -dot(direction_, separation_.normal);
    }
    bool nears() const { return speed_ > kParallel; }
    /// Before it the gap is larger than `wanted`.
    double earliest(double wanted) const { return at_ + (gap_ - wanted) / speed_; }
    double minGapAt(double at) const { return gap_ - speed_ * (at - at_); }

  private:
    const SolidTriangle& triangle_;
    UprightLine line_;
    Vec3d start_, direction_;
    double radius_;
    double at_ = 0, gap_ = 0, speed_ = 0;
    Separation separation_;
};

/// The contact that stops the capsule.
struct Stop {
    double travel = 0;
    double speed = 0; ///< by which the gap closes, per metre
    Separation separation;
};

/// The nearest first: the edges between the triangles of one wall are farther than the wall.
bool before(const Stop& a, const Stop& b) {
    if (a.travel != b.travel) return a.travel < b.travel;
    if (a.separation.distance != b.separation.distance) return a.separation.distance < b.separation.distance;
    return a.speed > b.speed;
}

/// Goes on until the skin is used up; false if that is not before `distance`.
bool reachesSkin(Approach& approach, double skin, double distance) {
    for (int i = 0; i < kSteps; ++i) {
        if (!approach.nears()) return false;
        if (approach.gap() <= skin + kSlack) return true;
        const double next = approach.earliest(skin);
        if (next > distance) return false;
        approach.moveTo(next);
    }
    return true;
}

/// Whether the capsule itself would touch, however far; not if at `distance` it still has the skin.
bool wouldTouch(Approach approach, double skin, double distance) {
    const double enough = std::max(skin - kSlack, 0.0);
    if (approach.minGapAt(distance) >= enough) return false;
    bool beyond = false;
    for (int i = 0; i < kSteps; ++i) {
        if (!approach.nears()) return false;
        if (approach.gap() <= kTolerance) return true;
        const double next = approach.earliest(0);
        const bool passesEnd = !beyond && next > distance;
        approach.moveTo(passesEnd ? distance : next);
        if (passesEnd && approach.gap() >= enough) return false;
        beyond = beyond || passesEnd;
    }
    return !beyond;
}

/// A triangle that only the skin touches is no obstacle: so the capsule glides over seams. Stops farther than
/// `limit` do not matter.
bool stops(Approach approach, double skin, double distance, double limit, Stop& stop) {
    skin = std::min(skin, approach.gap());
    if (!reachesSkin(approach, skin, limit) || !wouldTouch(approach, skin, distance)) return false;
    stop = {approach.at(), approach.speed(), approach.separation()};
    return true;
}

} // namespace

Sweep sweepCapsule(std::span<const SolidTriangle> triangles, const UprightLine& core, double radius,
                   double skin, Vec3d direction, double distance) {
    Sweep sweep;
    sweep.travel = distance;
    Stop first;
    const Box3d box = sweptBox(core, radius + skin, direction * distance);
    for (const SolidTriangle& triangle : triangles) {
        if (!triangle.box.overlaps(box)) continue;
        Stop stop;
        const Approach approach(triangle, core, radius, direction);
        if (!stops(approach, skin, distance, sweep.hit ? first.travel : distance, stop)) continue;
        if (sweep.hit && !before(stop, first)) continue;
        first = stop;
        sweep.hit = true;
    }
    if (!sweep.hit) return sweep;
    sweep.travel = first.travel;
    sweep.normal = first.separation.normal;
    sweep.point = first.separation.onTriangle;
    sweep.onFace = first.separation.onFace;
    constexpr double kNothing = 1e-7; // so that what rests stays where it is
    if (sweep.travel < kNothing) sweep.travel = 0;
    return sweep;
}

} // namespace rtcore
