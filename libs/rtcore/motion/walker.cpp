#include "rtcore/motion/walker.h"

#include "rtcore/motion/eye_spring.h"
#include "rtcore/motion/ground.h"
#include "rtcore/motion/walk_step.h"

namespace rtcore {

namespace {

constexpr double kBelowWorld = 20; ///< metres

} // namespace

Walker::Walker(const KdTree& tree, const Mesh& mesh, const WorldFrame& frame, const WalkShape& shape)
    : shape_(shape), around_(tree, mesh, frame, shape_) {}

Vec3d Walker::eye() const {
    return state_.feet + kUp * (state_.height - shape_.eyeBelowTop + state_.eyeOffset);
}

bool Walker::atRest() const {
    return state_.grounded && state_.velocity == Vec3d{} && state_.eyeOffset == 0 && state_.eyeSpeed == 0 &&
           !state_.climbing && state_.debt == 0 && state_.height == shape_.of(state_.stance).height;
}

/// Puts the player there if it sees that from `from`; whether it has room.
bool Walker::tryAt(Vec3d eye, Vec3d from, Stance stance) {
    if (eye != from && !around_.sees(from, eye)) return false;
    const double height = shape_.of(stance).height;
    settled_ = false;
    state_ = {};
    state_.feet = eye - kUp * (height - shape_.eyeBelowTop);
    state_.height = height;
    state_.stance = stance;
    around_.gather(state_, 0);
    return around_.body(height).isFree(state_.feet);
}

bool Walker::enter(Vec3d eye) {
    if (!isFinite(eye)) return false;
    const WalkState before = state_;
    const bool floorBefore = onUnseenFloor();
    around_.haveUnseenFloor(!around_.anythingBelow(eye));
    static constexpr Vec3d kWays[] = {{0, 0, 1},  {0, 0, -1}, {1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                      {0, -1, 0}, {1, 1, 0},  {-1, 1, 0}, {1, -1, 0}, {-1, -1, 0}};
    for (const double distance : {0.0, 0.125, 0.25, 0.5, 0.75, 1.0}) {
        for (const Vec3d way : kWays) {
            const Vec3d there = eye + normalize(way) * distance;
            for (const Stance stance : {Stance::Stand, Stance::Crouch, Stance::Crawl}) {
                if (!tryAt(there, eye, stance)) continue;
                if (onUnseenFloor() && state_.feet.z < around_.lowest()) continue;
                poses_.begin();
                return true;
            }
            if (distance == 0) break;
        }
    }
    state_ = before;
    around_.haveUnseenFloor(floorBefore);
    return false;
}

bool Walker::tick(const WalkInput& input, MotionTrail* trail) {
    const WalkState last = state_;
    state_.jumpWish = input.jump && !state_.jumpHeld ? 0 : ticksLater(state_.jumpWish);
    state_.jumpHeld = input.jump;
    state_.sinceGround = ticksLater(state_.sinceGround);
    state_.sinceJump = ticksLater(state_.sinceJump);
    settled_ = settled_ && input.none() && state_.jumpWish >= kJumpWishTicks;
    if (settled_) {
        state_.sinceGround = 0;
        poses_.note(state_);
        return true;
    }

    WalkStep(shape_, around_, state_, trail).act(input);
    easeEye(shape_, around_.triangles(), state_);
    if (!isFinite(state_.feet) || state_.feet.z < around_.lowest() - kBelowWorld) {
        if (putBack()) return true;
        state_ = last;
        return false;
    }
    if (!around_.body(state_.height).isFree(state_.feet)) {
        const WalkState failed = state_;
        state_ = last;
        state_.velocity = {};
        state_.climbing = false;
        state_.jumpWish = failed.jumpWish;
        state_.jumpHeld = failed.jumpHeld;
    }
    settled_ = input.none() && state_.feet == last.feet && state_.floor == last.floor && atRest();
    poses_.note(state_);
    return true;
}

bool Walker::putBack() {
    const auto pose = poses_.takeLast();
    if (!pose) return false;
    settled_ = false;
    state_ = *pose;
    around_.gather(state_, 0);
    return true;
}

} // namespace rtcore
