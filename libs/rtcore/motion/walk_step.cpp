#include "rtcore/motion/walk_step.h"

#include "rtcore/motion/ground.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

constexpr int kCoyoteTicks = 12;      ///< after leaving a floor one may still jump
constexpr int kFreeOfFloorTicks = 12; ///< after a jump the floor does not pull back
constexpr int kLookForLedge = 3;      ///< in the air, in one tick of so many

/// Towards `to` by at most `by`.
double approach(double from, double to, double by) { return std::clamp(to, from - by, from + by); }

Stance wantedStance(const WalkInput& input) {
    return input.crawl ? Stance::Crawl : input.crouch ? Stance::Crouch : Stance::Stand;
}

} // namespace

void WalkStep::act(const WalkInput& input) {
    const bool wasGrounded = state_.grounded;
    around_.gather(state_, (length(state_.velocity) + shape_.gravity * kTickSeconds +
                            std::max(shape_.sprint * shape_.stand.speed, shape_.climbSpeed)) *
                               kTickSeconds);
    recover();
    changeStance(input);
    if (state_.climbing) {
        climb();
    } else {
        startJump();
        const Vec3d wanted = wish(input);
        accelerate(wanted);
        if (state_.grounded) {
            walk();
        } else {
            fly(wanted);
        }
    }
    if (!state_.climbing) settle(wasGrounded);
}

/// Back to the full distance from what the skin touches, a little in every step; not where that would bring
/// it nearer to something else.
void WalkStep::recover() {
    const Body b = body();
    double budget = 1e-3;
    for (int pass = 0; pass < 8 && budget > 0; ++pass) {
        constexpr double kEnough = 1e-5;
        const auto deepest = b.nearest(state_.feet);
        if (!deepest || deepest->distance >= b.reach() - kEnough) return;
        // Out of all at once: in a corner, away from one wall alone may be nearer to the other.
        Vec3d push;
        for (const Separation& s : b.contacts(state_.feet)) {
            const double lacking = b.reach() - s.distance - dot(push, s.normal);
            if (lacking > 0) push += s.normal * lacking;
        }
        const double whole = length(push);
        if (!(whole > 0)) return;
        const double taken = std::min(budget, whole);
        const Vec3d feet = state_.feet + push * (taken / whole);
        const auto then = b.nearest(feet);
        constexpr double kBetter = 1e-7;
        if (then && then->distance <= deepest->distance + kBetter) return;
        state_.feet = feet;
        if (trail_ != nullptr) trail_->push_back(feet);
        budget -= taken;
    }
}

void WalkStep::changeStance(const WalkInput& input) {
    const Stance wanted = wantedStance(input);
    Stance target = Stance::Crawl;
    for (const Stance stance : {Stance::Stand, Stance::Crouch}) {
        if (stance > wanted) continue;
        const double height = shape_.of(stance).height;
        if (height <= state_.height || around_.body(height).isFree(state_.feet)) {
            target = stance;
            break;
        }
    }
    state_.stance = target;
    state_.height = approach(state_.height, shape_.of(target).height, shape_.stanceRate * kTickSeconds);
}

void WalkStep::startJump() {
    const double height = shape_.of(state_.stance).jump;
    const bool onFloor = state_.grounded || state_.sinceGround < kCoyoteTicks;
    if (state_.jumpWish >= kJumpWishTicks || !onFloor || !(height > 0)) return;
    state_.velocity.z = std::sqrt(2 * shape_.gravity * height);
    state_.takeOff = state_.feet.z;
    state_.grounded = false;
    state_.jumpWish = kForgetTicks;
    state_.sinceJump = 0;
    state_.sinceGround = kForgetTicks;
    state_.debt = 0;
}

Vec3d WalkStep::wish(const WalkInput& input) const {
    const double whole = std::sqrt(input.forward * input.forward + input.right * input.right);
    if (!(whole > 0)) return {};
    const double speed = shape_.of(state_.stance).speed / whole;
    const bool sprints = input.sprint && state_.stance == Stance::Stand && input.forward > 0;
    const Vec3d aside{input.ahead.y, -input.ahead.x, 0};
    return input.ahead * (input.forward * speed * (sprints ? shape_.sprint : 1)) +
           aside * (input.right * speed);
}

void WalkStep::accelerate(Vec3d wanted) {
    const Vec3d change = wanted - horizontal(state_.velocity);
    const double max = (state_.grounded ? shape_.groundForce : shape_.airForce) * kTickSeconds;
    const double whole = length(change);
    if (whole <= max) {
        state_.velocity = {wanted.x, wanted.y, state_.velocity.z};
    } else {
        state_.velocity += change * (max / whole);
    }
}

void WalkStep::walk() {
    state_.velocity.z = 0;
    const Vec3d due = state_.velocity * kTickSeconds;
    const double paid = std::min(state_.debt, length(due));
    state_.debt = due == Vec3d{} ? 0 : state_.debt - paid;
    const Vec3d move = due - normalize(due) * paid;
    constexpr double kNothing = 1e-9;
    if (length(move) < kNothing) return;
    const Body b = body();
    MotionTrail parts;
    const Slide slide = slideOnGround(b, state_.feet, move, state_.floor, &parts);
    if (slide.blocked) {
        const double high = shape_.of(state_.stance).step;
        MotionTrail way;
        auto step = stepUp(b, state_.feet, move, high, slide.feet, &way);
        // Along a wall it may come upon a step that straight ahead is none.
        if (!step && cross(slide.blockedMove, move) != Vec3d{}) {
            step = stepUp(b, state_.feet, slide.blockedMove, high, slide.feet, &way);
            if (step && !(dot(step->feet - slide.feet, move) > 0)) step.reset();
        }
        if (step) {
            note(way);
            state_.eyeOffset -= step->feet.z - state_.feet.z;
            state_.feet = step->feet;
            state_.debt = step->extra;
            return;
        }
    }
    if (slide.rolled) state_.eyeOffset -= slide.feet.z - state_.feet.z;
    state_.feet = slide.feet;
    state_.velocity = slide.met.clip(state_.velocity);
    note(parts);
}

void WalkStep::fly(const Vec3d& wanted) {
    const double before = state_.velocity.z;
    state_.velocity.z = std::max(before - shape_.gravity * kTickSeconds, -shape_.terminal);
    Vec3d move = state_.velocity * kTickSeconds;
    move.z = (before + state_.velocity.z) / 2 * kTickSeconds;
    const Body b = body();
    const Slide slide = slideInAir(b, state_.feet, move, trail_);
    state_.feet = slide.feet;
    if (slide.landed) state_.velocity.z = std::max(state_.velocity.z, 0.0);
    state_.velocity = slide.met.clip(state_.velocity);
    if (slide.ceiling) state_.velocity.z = std::min(state_.velocity.z, 0.0);
    grabLedge(wanted, slide);
}

/// Against a wall while jumping: is its top within reach?
void WalkStep::grabLedge(const Vec3d& wanted, const Slide& slide) {
    const bool jumped = state_.sinceJump < kForgetTicks && state_.sinceJump % kLookForLedge == 0;
    if (!jumped || !slide.blocked || !(dot(wanted, slide.blocked->normal) < 0)) return;
    const double top = state_.takeOff + shape_.ledge * state_.height / shape_.stand.height;
    const Vec3d ahead = normalize(-horizontal(slide.blocked->normal));
    if (!(top > state_.feet.z) || ahead == Vec3d{}) return;
    const auto ledge = findLedge(around_.climber(state_, top), state_.feet, ahead, top);
    if (!ledge) return;
    state_.climbing = true;
    state_.ledge = *ledge;
    state_.velocity = {};
}

void WalkStep::climb() {
    const Body b = body();
    const Vec3d left = state_.ledge - state_.feet;
    const bool rising = left.z > 0;
    const Vec3d way = rising ? Vec3d{0, 0, left.z} : horizontal(left);
    const double speed = rising ? shape_.climbSpeed : shape_.of(state_.stance).speed;
    const double wanted = std::min(length(way), speed * kTickSeconds);
    const Vec3d direction = normalize(way);
    const double travel = wanted > 0 ? b.sweep(state_.feet, direction, wanted).travel : 0;
    constexpr double kThere = 1e-6;
    // Straight up, the last bit must arrive exactly, or it would never be done.
    state_.feet =
        travel == wanted && wanted == length(way) ? state_.feet + way : state_.feet + direction * travel;
    if (rising && travel > 0 && std::fabs(left.z - travel) < kThere) state_.feet.z = state_.ledge.z;
    if (trail_ != nullptr) trail_->push_back(state_.feet);
    const bool arrived = !rising && length(way) - travel < kThere;
    if (arrived || travel < kThere / 10) {
        state_.climbing = false;
        state_.sinceJump = kForgetTicks;
    }
}

/// Decides whether the player stands, and draws it down to the floor that it walks on.
void WalkStep::settle(bool wasGrounded) {
    const bool rising = state_.velocity.z > 0;
    const bool justJumped = state_.sinceJump < kFreeOfFloorTicks;
    const double step = shape_.of(state_.stance).step;
    const Body b = body();
    state_.grounded = false;
    if (rising) return;
    constexpr double kTouch = 2e-3;
    const bool follow = wasGrounded && !justJumped;
    const auto ground = findGround(b, state_.feet, follow ? std::max(step, kTouch) : kTouch, step);
    if (ground) {
        const double down = state_.feet.z - ground->feet.z;
        constexpr double kSlope = 5e-3; // what following a floor does not explain
        if (follow && (down > kSlope || ground->floor.edge)) state_.eyeOffset += down;
        state_.feet = ground->feet;
        if (trail_ != nullptr && down > 0) trail_->push_back(state_.feet);
        state_.floor = ground->floor;
        state_.grounded = true;
    } else if (!b.contacts(state_.feet).empty() && isWedged(b, state_.feet)) {
        state_.floor = {};
        state_.grounded = true;
    }
    if (!state_.grounded) return;
    state_.velocity.z = 0;
    state_.sinceGround = 0;
    state_.sinceJump = kForgetTicks;
}

void WalkStep::note(const MotionTrail& trail) {
    if (trail_ != nullptr) trail_->insert(trail_->end(), trail.begin(), trail.end());
}

} // namespace rtcore
