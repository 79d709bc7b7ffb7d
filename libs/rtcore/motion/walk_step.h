/// One step of a walker.
#pragma once

#include "rtcore/motion/walk_shape.h"
#include "rtcore/motion/walk_state.h"
#include "rtcore/motion/walk_surroundings.h"

namespace rtcore {

/// The jump key counts so many ticks before a floor is reached.
inline constexpr int kJumpWishTicks = 15;

/// Changes `state` by one tick. All that it is given must outlive it; it lives for the step.
class WalkStep {
  public:
    /// `trail`: may be null.
    WalkStep(const WalkShape& shape, WalkSurroundings& around, WalkState& state, MotionTrail* trail)
        : shape_(shape), around_(around), state_(state), trail_(trail) {}

    /// Back from what is too near, stance, jump, move, and down to the floor. The eye is another matter
    /// (eye_spring.h). May end inside a surface: to be looked at afterwards.
    void act(const WalkInput& input);

  private:
    Body body() const { return around_.body(state_.height); }
    void recover();
    void changeStance(const WalkInput& input);
    void startJump();
    Vec3d wish(const WalkInput& input) const;
    void accelerate(Vec3d wanted);
    void walk();
    void fly(const Vec3d& wanted);
    void grabLedge(const Vec3d& wanted, const Slide& slide);
    void climb();
    void settle(bool wasGrounded);
    void note(const MotionTrail& trail);

    const WalkShape& shape_;
    WalkSurroundings& around_;
    WalkState& state_;
    MotionTrail* trail_;
};

} // namespace rtcore
