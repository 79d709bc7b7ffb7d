/// Finds the floor that the player stands on, and the steps and ledges that it climbs.
#pragma once

#include "rtcore/motion/body.h"
#include "rtcore/motion/slide.h"

#include <optional>

namespace rtcore {

inline constexpr Vec3d kUp{0, 0, 1}; ///< of the space that the player walks in

struct Ground {
    Vec3d feet;       ///< standing on it
    FloorPlane floor; ///< to follow
};

/// The floor to stand on within `distance` below `feet`. A surface that is too steep is none, but the edge of
/// a step is one: a floor right behind it and one under the player within `step` tell them from the edge of a
/// cliff.
std::optional<Ground> findGround(const Body& body, Vec3d feet, double distance, double step);

/// Held up by steep surfaces on several sides, as in a crevice.
bool isWedged(const Body& body, Vec3d feet);

/// Where a player who is stopped walking along `move` (horizontal) stands after a step of at most `step`, if
/// there is room and it gets farther than `without`, where it would be otherwise. `extra` is what it went
/// beyond `move`: a short move has to reach beyond the edge.
struct StepUp {
    Vec3d feet;
    double extra = 0;
};
std::optional<StepUp> stepUp(const Body& body, Vec3d feet, Vec3d move, double step, Vec3d without,
                             MotionTrail* trail = nullptr);

/// Where a player stands after it has climbed a ledge ahead that is at most at the height `top`.
std::optional<Vec3d> findLedge(const Body& body, Vec3d feet, Vec3d ahead, double top);

} // namespace rtcore
