/// Walk-through mode (thesis 7.2.1): a player with a body, who walks, falls, jumps, climbs, crouches and
/// crawls.
#pragma once

#include "rtcore/math/vec.h"
#include "rtcore/motion/ground.h"
#include "rtcore/motion/nearby_triangles.h"
#include "rtcore/motion/slide.h"
#include "rtcore/motion/walk_shape.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// Physics goes in steps of this length, whatever the rate of frames: so the same keys give the same path.
inline constexpr int kTicksPerSecond = 120;
inline constexpr double kTickSeconds = 1.0 / kTicksPerSecond;

/// What is asked of the player in one step.
struct WalkInput {
    Vec3d ahead{0, 1, 0}; ///< unit, horizontal: where it looks
    double forward = 0;   ///< -1, 0, 1
    double right = 0;     ///< -1, 0, 1
    bool jump = false, crouch = false, crawl = false, sprint = false;
    bool none() const { return forward == 0 && right == 0 && !jump && !crouch && !crawl; }
};

/// All that decides how it goes on; metres and seconds, z up.
struct WalkState {
    Vec3d feet, velocity;
    double height = 1.8; ///< of the body now: changes smoothly between stances
    Stance stance = Stance::Stand;
    bool grounded = false;
    FloorPlane floor;       ///< to follow while grounded
    double eyeOffset = 0;   ///< of the eye from its position in the body: smooths steps
    double eyeSpeed = 0;    ///< by which that changes
    double debt = 0;        ///< metres gone too far on an edge
    double takeOff = 0;     ///< height of the floor that was jumped from
    int sinceGround = 1000; ///< ticks since it stood
    int sinceJump = 1000;   ///< ticks since it jumped
    int jumpWish = 1000;    ///< ticks since the jump key went down
    bool jumpHeld = false;
    bool climbing = false;
    Vec3d ledge; ///< where climbing ends
    friend bool operator==(const WalkState&, const WalkState&) = default;
};

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
    void useTree(const KdTree& tree);

    /// Puts the player where its eye is at `eye` or, when there is no room, within a metre of it and in its
    /// sight. Where nothing is below, as beside a model that is looked at from outside, an unseen floor at
    /// the lowest point of the scene carries it. False, and nothing changed, when there is no room at all,
    /// or nothing below that could carry.
    bool enter(Vec3d eye);
    /// Since the last enter() there is an unseen floor.
    bool onUnseenFloor() const { return unseenFloor_; }

    /// One step of kTickSeconds. False when the walker fell out of the world and there is nowhere to put
    /// it back to: the state is the last good one then.
    bool tick(const WalkInput& input, MotionTrail* trail = nullptr);

    const WalkState& state() const { return state_; }
    Vec3d eye() const;
    /// Without input nothing would change any more.
    bool atRest() const;

  private:
    struct Pose {
        Vec3d feet;
        double height = 0;
        Stance stance = Stance::Stand;
    };

    Body body(double height) { return {triangles_, shape_, height}; }
    void gather(double move);
    std::span<const SolidTriangle> withUnseenFloor(std::span<const SolidTriangle> triangles,
                                                   const Box3d& box);
    bool anythingBelow(Vec3d eye) const;
    void act(const WalkInput& input, MotionTrail* trail);
    void recover(MotionTrail* trail);
    void changeStance(const WalkInput& input);
    void startJump();
    Vec3d wish(const WalkInput& input) const;
    void accelerate(Vec3d wanted);
    void walk(MotionTrail* trail);
    void fly(const Vec3d& wanted, MotionTrail* trail);
    void climb(MotionTrail* trail);
    void settle(bool wasGrounded, MotionTrail* trail);
    void easeEye();
    void savePose();
    bool restorePose();
    bool fitsAt(Vec3d eye, Vec3d from, Stance stance);

    KdTree tree_;
    Mesh mesh_;
    WorldFrame frame_;
    WalkShape shape_;
    NearbyTriangles nearby_, nearLedge_;
    std::span<const SolidTriangle> triangles_;
    double lowest_;                        ///< height of the scene's lowest point
    bool unseenFloor_ = false;             ///< there
    std::vector<SolidTriangle> withFloor_; ///< triangles_, where it is among them
    WalkState state_;
    std::array<Pose, 16> saved_{};
    int savedCount_ = 0, savedNext_ = 0;
    int sinceSaved_ = 0;
    bool settled_ = false; ///< a step without input changed nothing
};

} // namespace rtcore
