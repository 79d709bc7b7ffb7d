/// The input of a walker, and all that decides how it goes on.
#pragma once

#include "rtcore/math/vec.h"
#include "rtcore/motion/slide.h"
#include "rtcore/motion/walk_shape.h"

namespace rtcore {

/// Physics goes in steps of this length, whatever the rate of frames: so the same keys give the same path.
inline constexpr int kTicksPerSecond = 120;
inline constexpr double kTickSeconds = 1.0 / kTicksPerSecond;

/// Ticks that are counted since something: those that are longer ago are all the same.
inline constexpr int kForgetTicks = 1000;
constexpr int ticksLater(int ticks) { return ticks < kForgetTicks ? ticks + 1 : kForgetTicks; }

/// The input of the player in one step.
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
    FloorPlane floor;               ///< to follow while grounded
    double eyeOffset = 0;           ///< of the eye from its position in the body: smooths steps
    double eyeSpeed = 0;            ///< by which that changes
    double debt = 0;                ///< metres gone too far on an edge
    double takeOff = 0;             ///< height of the floor that was jumped from
    int sinceGround = kForgetTicks; ///< ticks since it stood
    int sinceJump = kForgetTicks;   ///< ticks since it jumped
    int jumpWish = kForgetTicks;    ///< ticks since the jump key went down
    bool jumpHeld = false;
    bool climbing = false;
    Vec3d ledge; ///< where climbing ends
    friend bool operator==(const WalkState&, const WalkState&) = default;
};

} // namespace rtcore
