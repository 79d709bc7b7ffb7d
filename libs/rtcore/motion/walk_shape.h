/// Sizes and speeds of the player in walk-through mode.
#pragma once

#include "rtcore/scene/scene.h"

namespace rtcore {

enum class Stance { Crawl, Crouch, Stand };

struct StanceShape {
    double height = 0; ///< m
    double step = 0;   ///< m, the highest that is stepped up
    double speed = 0;  ///< m/s
    double jump = 0;   ///< m
};

/// Metres and seconds. The proportions are those of a man of 1.80 m; all lengths scale with the height.
struct WalkShape {
    WalkShape() : WalkShape(WalkParameters{}) {}
    /// Parameters that make no sense (not finite, not positive, a step higher than half the player) count as
    /// their defaults or are limited.
    explicit WalkShape(const WalkParameters& parameters);

    const StanceShape& of(Stance stance) const {
        return stance == Stance::Stand ? stand : stance == Stance::Crouch ? crouch : crawl;
    }

    StanceShape stand, crouch, crawl;
    double radius = 0.29;       ///< that nothing ever enters
    double skin = 0.01;         ///< kept free around it
    double eyeBelowTop = 0.1;   ///< of the eye under the crown
    double eyeClearance = 0.09; ///< of the eye from everything
    double ledge = 1.1;         ///< the highest that is climbed by jumping against it
    double climbSpeed = 2;      ///< upwards
    double sprint = 2;          ///< times the speed ahead
    double gravity = 9.81;      ///< m/s^2
    double terminal = 55;       ///< m/s
    double groundForce = 40;    ///< m/s^2 by which walking changes the velocity
    double airForce = 8;        ///< the same in the air
    double stanceRate = 2.8;    ///< m/s at which the height changes
    double walkable = 0.7;      ///< cosine of the steepest floor: 45.6 degrees
};

} // namespace rtcore
