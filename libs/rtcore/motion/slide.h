/// Moves the player along what it runs into.
#pragma once

#include "rtcore/motion/body.h"

#include <optional>
#include <vector>

namespace rtcore {

/// Surfaces met during one step.
class MetPlanes {
  public:
    void add(Vec3d normal) { normals_.push_back(normal); }
    /// The nearest to `move` that leads into none of them: along one, along the crease of two, or zero.
    Vec3d clip(Vec3d move) const;

  private:
    bool feasible(Vec3d move) const;
    std::vector<Vec3d> normals_;
};

/// The floor under a player that walks.
struct FloorPlane {
    Vec3d normal{0, 0, 1};
    bool edge = false; ///< the round body rolls over an edge: the floor around is not as steep
    friend bool operator==(const FloorPlane&, const FloorPlane&) = default;
};

struct Slide {
    bool rolled = false;          ///< over an edge
    Vec3d feet;                   ///< where it ended
    MetPlanes met;                ///< what the velocity loses its parts into
    std::optional<Sweep> blocked; ///< the last steep surface that was in the way
    Vec3d blockedMove;            ///< what was left to go when it came in the way
    bool landed = false;          ///< in the air: came upon a walkable surface
    bool ceiling = false;         ///< something overhead was in the way
};

/// Positions at the end of each part of a step, for tests; null: not wanted.
using MotionTrail = std::vector<Vec3d>;

/// `move` is horizontal. Its heading and length are kept along the `floor`; steep surfaces
/// are walls, whatever their slope.
Slide slideOnGround(const Body& body, Vec3d feet, Vec3d move, FloorPlane floor, MotionTrail* trail = nullptr);
Slide slideInAir(const Body& body, Vec3d feet, Vec3d move, MotionTrail* trail = nullptr);

} // namespace rtcore
