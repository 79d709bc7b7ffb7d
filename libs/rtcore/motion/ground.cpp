#include "rtcore/motion/ground.h"

#include <algorithm>

namespace rtcore {

namespace {

constexpr double kRounding = 1e-3; ///< metres that a step may be higher than allowed
constexpr double kBehind = 0.01;   ///< metres behind an edge where its floor is looked for

/// A floor right behind the edge at `point`, seen from the player.
bool leadsToFloor(const Body& body, Vec3d feet, Vec3d point) {
    const Vec3d away = normalize(horizontal(point - feet));
    constexpr double kOver = 0.05;
    const auto floor = body.floorBelow(point + away * kBehind + kUp * kOver, 2 * kOver);
    return floor && floor->walkable;
}

bool isFloor(const Body& body, Vec3d feet, Vec3d normal, Vec3d point) {
    return normal.z >= body.shape().walkable || (normal.z > 0 && leadsToFloor(body, feet, point));
}

} // namespace

std::optional<Ground> findGround(const Body& body, Vec3d feet, double distance, double step) {
    const Sweep down = body.sweep(feet, -kUp, distance);
    if (!down.hit) return std::nullopt;
    Ground ground{feet - kUp * down.travel, {}};
    double flattest = 0;
    bool edge = false;
    const auto look = [&](Vec3d normal, Vec3d point, bool onFace) {
        if (normal.z >= body.shape().walkable && normal.z > flattest) {
            flattest = normal.z;
            ground.floor = {normal, !onFace};
        }
        edge = edge || (normal.z > kRounding && leadsToFloor(body, ground.feet, point));
    };
    look(down.normal, down.point, down.onFace);
    for (const Separation& s : body.contacts(ground.feet)) look(s.normal, s.onTriangle, s.onFace);
    if (flattest > 0) return ground;
    if (!edge) return std::nullopt;
    const auto below = body.floorBelow(body.lowCentre(ground.feet), body.reach() + step);
    if (!below || !below->walkable) return std::nullopt;
    return ground;
}

bool isWedged(const Body& body, Vec3d feet) {
    constexpr double kTrial = 0.01, kSunk = 0.001;
    const Slide trial = slideInAir(body, feet, kUp * -kTrial);
    return feet.z - trial.feet.z < kSunk;
}

std::optional<StepUp> stepUp(const Body& body, Vec3d feet, Vec3d move, double step, Vec3d without,
                             MotionTrail* trail) {
    constexpr double kMin = 0.02;
    const double wanted = length(move);
    if (!(wanted > 0)) return std::nullopt;
    const Vec3d ahead = move * (1 / wanted);
    // Beyond what stopped it; else the step would not show.
    const double distance = std::max(wanted, dot(without - feet, ahead) + kMin);
    const double raised = body.sweep(feet, kUp, step).travel;
    const Vec3d above = feet + kUp * raised;
    MotionTrail parts{above};
    const Slide over = slideOnGround(body, above, ahead * distance, {}, &parts);
    const double max = over.feet.z - feet.z;
    if (!(max > 0)) return std::nullopt;
    const Sweep down = body.sweep(over.feet, -kUp, max);
    if (!down.hit || down.point.z - feet.z > step + kRounding) return std::nullopt;
    const StepUp result{over.feet - kUp * down.travel, std::max(0.0, dot(over.feet - feet, ahead) - wanted)};
    if (!isFloor(body, result.feet, down.normal, down.point)) return std::nullopt;
    if (dot(result.feet - without, ahead) <= kRounding) return std::nullopt;
    if (trail != nullptr) {
        trail->insert(trail->end(), parts.begin(), parts.end());
        trail->push_back(result.feet);
    }
    return result;
}

std::optional<Vec3d> findLedge(const Body& body, Vec3d feet, Vec3d ahead, double top) {
    const double rise = top - feet.z;
    if (!(rise > 0)) return std::nullopt;
    const Sweep up = body.sweep(feet, kUp, rise + body.shape().skin);
    const Vec3d above = feet + kUp * up.travel;
    // As far as it takes to have the axis over the ledge.
    const double distance = body.reach() + 10 * body.shape().skin;
    const Sweep over = body.sweep(above, ahead, distance);
    if (over.travel < distance / 3) return std::nullopt;
    const Vec3d there = above + ahead * over.travel;
    const Sweep down = body.sweep(there, -kUp, up.travel);
    if (!down.hit || down.point.z > top + kRounding) return std::nullopt;
    const Vec3d landing = there - kUp * down.travel;
    if (landing.z <= feet.z + kRounding || !isFloor(body, landing, down.normal, down.point))
        return std::nullopt;
    return landing;
}

} // namespace rtcore
