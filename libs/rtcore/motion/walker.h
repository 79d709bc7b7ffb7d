/// Walk-through mode (thesis 7.2.1): a player with a body, who walks, falls, jumps, climbs, crouches and
/// crawls.
#pragma once

#include "rtcore/motion/standing_poses.h"
#include "rtcore/motion/walk_shape.h"
#include "rtcore/motion/walk_state.h"
#include "rtcore/motion/walk_surroundings.h"

namespace rtcore {

/// One thread. Never inside a surface: every step ends where the hard capsule (WalkShape::radius) is free of
/// all triangles, or does not happen. Needs no closed meshes, no orientation of triangles. Work a tick: tens
/// of microseconds.
class Walker {
  public:
    /// `tree` and `mesh` must outlive it.
    Walker(const KdTree& tree, const Mesh& mesh, const WorldFrame& frame, const WalkShape& shape);

    Walker(const Walker&) = delete;
    Walker& operator=(const Walker&) = delete;

    /// Another tree of the same mesh, or of a part of it; must outlive it.
    void useTree(const KdTree& tree) { around_.useTree(tree); }
    /// What they take away of the model is no wall any more, but still carries; triangles whose value in
    /// `uncut` is not 0 stay as they are.
    void useSections(std::span<const SectionPlane> planes, std::span<const std::uint8_t> uncut = {}) {
        around_.useSections(planes, uncut);
        settled_ = false;
    }

    /// Puts the player where its eye is at `eye` or, when there is no room, within a metre of it and in its
    /// sight. Where nothing is below, as beside a model that is looked at from outside, an unseen floor at
    /// the lowest point of the scene carries it. False, and nothing changed, when there is no room at all,
    /// or nothing below that could carry.
    bool enter(Vec3d eye);
    /// Since the last enter() there is an unseen floor.
    bool onUnseenFloor() const { return around_.hasUnseenFloor(); }

    /// One step of kTickSeconds. False when the walker fell out of the world and there is nowhere to put
    /// it back to: the state is the last good one then.
    bool tick(const WalkInput& input, MotionTrail* trail = nullptr);

    const WalkState& state() const { return state_; }
    Vec3d eye() const;
    /// Without input nothing would change any more.
    bool atRest() const;

  private:
    bool tryAt(Vec3d eye, Vec3d from, Stance stance);
    bool putBack();

    WalkShape shape_;
    WalkSurroundings around_;
    WalkState state_;
    StandingPoses poses_;
    bool settled_ = false; ///< a step without input changed nothing
};

} // namespace rtcore
