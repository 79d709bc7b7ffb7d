#include "rtcore/motion/walker.h"

#include "rtcore/kernels/single_ray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rtcore {

namespace {

constexpr Vec3d kUp{0, 0, 1};
constexpr double kMargin = 0.1;       ///< metres around what a step may touch
constexpr int kCoyoteTicks = 12;      ///< after leaving a floor one may still jump
constexpr int kJumpWishTicks = 15;    ///< before reaching a floor one may already press
constexpr int kFreeOfFloorTicks = 12; ///< after a jump the floor does not pull back
constexpr int kForgetTicks = 1000;
constexpr int kLookForLedge = 3; ///< in the air, in one tick of so many
constexpr int kSaveTicks = kTicksPerSecond / 2;
constexpr double kBelowWorld = 20;   ///< metres
constexpr double kEyeRate = 20;      ///< 1/s; of the spring that draws the eye back to its place
constexpr double kEyeDecay = 0.8465; ///< e^(-kEyeRate * kTickSeconds)

/// Towards `to` by at most `by`.
double approach(double from, double to, double by) { return std::clamp(to, from - by, from + by); }

int later(int ticks) { return std::min(ticks + 1, kForgetTicks); }

double lowestPoint(const KdTree& tree, const WorldFrame& frame) {
    if (tree.bounds.empty()) return 0;
    double lowest = frame.toMetres(tree.bounds.lo).z;
    for (int corner = 1; corner < 8; ++corner) {
        const Box3& b = tree.bounds;
        lowest = std::min(
            lowest, frame
                        .toMetres({(corner & 1) != 0 ? b.hi.x : b.lo.x, (corner & 2) != 0 ? b.hi.y : b.lo.y,
                                   (corner & 4) != 0 ? b.hi.z : b.lo.z})
                        .z);
    }
    return lowest;
}

Stance wantedStance(const WalkInput& input) {
    return input.crawl ? Stance::Crawl : input.crouch ? Stance::Crouch : Stance::Stand;
}

} // namespace

Walker::Walker(const KdTree& tree, const Mesh& mesh, const WorldFrame& frame, const WalkShape& shape)
    : tree_(tree), mesh_(mesh), frame_(frame), shape_(shape), nearby_(tree, mesh, frame),
      nearLedge_(tree, mesh, frame, 0), lowest_(lowestPoint(tree, frame)) {}

Vec3d Walker::eye() const {
    return state_.feet + kUp * (state_.height - shape_.eyeBelowTop + state_.eyeOffset);
}

bool Walker::atRest() const {
    return state_.grounded && state_.velocity == Vec3d{} && state_.eyeOffset == 0 && state_.eyeSpeed == 0 &&
           !state_.climbing && state_.debt == 0 && state_.height == shape_.of(state_.stance).height;
}

void Walker::gather(double move) {
    const Box3d here = body(std::max(state_.height, shape_.stand.height)).box(state_.feet);
    const double beside = move + kMargin;
    const Box3d box = here.grown({beside, beside, beside + shape_.stand.step});
    triangles_ = withUnseenFloor(nearby_.in(box), box);
}

/// One triangle around the player, wherever it is: without edges near it.
std::span<const SolidTriangle> Walker::withUnseenFloor(std::span<const SolidTriangle> triangles,
                                                       const Box3d& box) {
    if (!unseenFloor_ || box.lo.z > lowest_ || box.hi.z < lowest_) return triangles;
    const double x = (box.lo.x + box.hi.x) / 2, y = (box.lo.y + box.hi.y) / 2;
    const double far = 10 * (box.hi.x - box.lo.x + box.hi.y - box.lo.y);
    const Vec3d a{x - 2 * far, y - far, lowest_}, b{x + 2 * far, y - far, lowest_},
        c{x, y + 2 * far, lowest_};
    withFloor_.assign(triangles.begin(), triangles.end());
    withFloor_.push_back({a, b, c, {{a.x, a.y, lowest_}, {b.x, c.y, lowest_}}});
    return withFloor_;
}

/// Under any part of the body.
bool Walker::anythingBelow(Vec3d eye) const {
    const Vec3 down = frame_.turnBack(-kUp);
    for (const Vec3d aside : {Vec3d{}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}}) {
        const Ray ray{frame_.toScene(eye + aside * shape_.radius), 0, down,
                      std::numeric_limits<float>::max()};
        if (occluded(tree_, mesh_, ray)) return true;
    }
    return false;
}

// --- entering -------------------------------------------------------------------------------------------

bool Walker::fitsAt(Vec3d eye, Vec3d from, Stance stance) {
    if (eye != from) {
        const Vec3 a = frame_.toScene(from), b = frame_.toScene(eye);
        if (occluded(tree_, mesh_, {a, 0, b - a, 1})) return false;
    }
    const double height = shape_.of(stance).height;
    settled_ = false;
    state_ = {};
    state_.feet = eye - kUp * (height - shape_.eyeBelowTop);
    state_.height = height;
    state_.stance = stance;
    gather(0);
    return body(height).isFree(state_.feet);
}

void Walker::useTree(const KdTree& tree) {
    tree_ = tree;
    nearby_.useTree(tree);
}

bool Walker::enter(Vec3d eye) {
    if (!isFinite(eye)) return false;
    const WalkState before = state_;
    const bool floorBefore = unseenFloor_;
    unseenFloor_ = !anythingBelow(eye);
    static constexpr Vec3d kWays[] = {{0, 0, 1},  {0, 0, -1}, {1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                      {0, -1, 0}, {1, 1, 0},  {-1, 1, 0}, {1, -1, 0}, {-1, -1, 0}};
    for (const double distance : {0.0, 0.125, 0.25, 0.5, 0.75, 1.0}) {
        for (const Vec3d way : kWays) {
            const Vec3d there = eye + normalize(way) * distance;
            for (const Stance stance : {Stance::Stand, Stance::Crouch, Stance::Crawl}) {
                if (!fitsAt(there, eye, stance)) continue;
                if (unseenFloor_ && state_.feet.z < lowest_) continue;
                savedCount_ = 0;
                sinceSaved_ = kSaveTicks; // the first floor is a place to come back to
                return true;
            }
            if (distance == 0) break;
        }
    }
    state_ = before;
    unseenFloor_ = floorBefore;
    return false;
}

// --- one step -------------------------------------------------------------------------------------------

bool Walker::tick(const WalkInput& input, MotionTrail* trail) {
    const WalkState last = state_;
    state_.jumpWish = input.jump && !state_.jumpHeld ? 0 : later(state_.jumpWish);
    state_.jumpHeld = input.jump;
    state_.sinceGround = later(state_.sinceGround);
    state_.sinceJump = later(state_.sinceJump);
    settled_ = settled_ && input.none() && state_.jumpWish >= kJumpWishTicks;
    if (settled_) {
        state_.sinceGround = 0;
        savePose();
        return true;
    }

    act(input, trail);
    if (!isFinite(state_.feet) || state_.feet.z < lowest_ - kBelowWorld) {
        if (restorePose()) return true;
        state_ = last;
        return false;
    }
    if (!body(state_.height).isFree(state_.feet)) {
        const WalkState failed = state_;
        state_ = last;
        state_.velocity = {};
        state_.climbing = false;
        state_.jumpWish = failed.jumpWish;
        state_.jumpHeld = failed.jumpHeld;
    }
    settled_ = input.none() && state_.feet == last.feet && state_.floor == last.floor && atRest();
    savePose();
    return true;
}

void Walker::act(const WalkInput& input, MotionTrail* trail) {
    const bool wasGrounded = state_.grounded;
    gather((length(state_.velocity) + shape_.gravity * kTickSeconds +
            std::max(shape_.sprint * shape_.stand.speed, shape_.climbSpeed)) *
           kTickSeconds);
    recover(trail);
    changeStance(input);
    if (state_.climbing) {
        climb(trail);
    } else {
        startJump();
        const Vec3d wanted = wish(input);
        accelerate(wanted);
        if (state_.grounded) {
            walk(trail);
        } else {
            fly(wanted, trail);
        }
    }
    if (!state_.climbing) settle(wasGrounded, trail);
    easeEye();
}

/// Back to the full distance from what the skin touches, a little in every step; not where that would bring
/// it nearer to something else.
void Walker::recover(MotionTrail* trail) {
    const Body b = body(state_.height);
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
        if (trail != nullptr) trail->push_back(feet);
        budget -= taken;
    }
}

void Walker::changeStance(const WalkInput& input) {
    const Stance wanted = wantedStance(input);
    Stance target = Stance::Crawl;
    for (const Stance stance : {Stance::Stand, Stance::Crouch}) {
        if (stance > wanted) continue;
        const double height = shape_.of(stance).height;
        if (height <= state_.height || body(height).isFree(state_.feet)) {
            target = stance;
            break;
        }
    }
    state_.stance = target;
    state_.height = approach(state_.height, shape_.of(target).height, shape_.stanceRate * kTickSeconds);
}

void Walker::startJump() {
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

Vec3d Walker::wish(const WalkInput& input) const {
    const double whole = std::sqrt(input.forward * input.forward + input.right * input.right);
    if (!(whole > 0)) return {};
    const double speed = shape_.of(state_.stance).speed / whole;
    const bool sprints = input.sprint && state_.stance == Stance::Stand && input.forward > 0;
    const Vec3d aside{input.ahead.y, -input.ahead.x, 0};
    return input.ahead * (input.forward * speed * (sprints ? shape_.sprint : 1)) +
           aside * (input.right * speed);
}

void Walker::accelerate(Vec3d wanted) {
    const Vec3d change = wanted - horizontal(state_.velocity);
    const double most = (state_.grounded ? shape_.groundForce : shape_.airForce) * kTickSeconds;
    const double whole = length(change);
    if (whole <= most) {
        state_.velocity = {wanted.x, wanted.y, state_.velocity.z};
    } else {
        state_.velocity += change * (most / whole);
    }
}

void Walker::walk(MotionTrail* trail) {
    state_.velocity.z = 0;
    const Vec3d due = state_.velocity * kTickSeconds;
    const double paid = std::min(state_.debt, length(due));
    state_.debt = due == Vec3d{} ? 0 : state_.debt - paid;
    const Vec3d move = due - normalize(due) * paid;
    constexpr double kNothing = 1e-9;
    if (length(move) < kNothing) return;
    const Body b = body(state_.height);
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
            if (trail != nullptr) trail->insert(trail->end(), way.begin(), way.end());
            state_.eyeOffset -= step->feet.z - state_.feet.z;
            state_.feet = step->feet;
            state_.debt = step->extra;
            return;
        }
    }
    if (slide.rolled) state_.eyeOffset -= slide.feet.z - state_.feet.z;
    state_.feet = slide.feet;
    state_.velocity = slide.met.clip(state_.velocity);
    if (trail != nullptr) trail->insert(trail->end(), parts.begin(), parts.end());
}

void Walker::fly(const Vec3d& wanted, MotionTrail* trail) {
    const double before = state_.velocity.z;
    state_.velocity.z = std::max(before - shape_.gravity * kTickSeconds, -shape_.terminal);
    Vec3d move = state_.velocity * kTickSeconds;
    move.z = (before + state_.velocity.z) / 2 * kTickSeconds;
    const Body b = body(state_.height);
    const Slide slide = slideInAir(b, state_.feet, move, trail);
    state_.feet = slide.feet;
    if (slide.landed) state_.velocity.z = std::max(state_.velocity.z, 0.0);
    state_.velocity = slide.met.clip(state_.velocity);
    if (slide.ceiling) state_.velocity.z = std::min(state_.velocity.z, 0.0);

    // Against a wall while jumping: is its top within reach?
    const bool jumped = state_.sinceJump < kForgetTicks && state_.sinceJump % kLookForLedge == 0;
    if (!jumped || !slide.blocked || !(dot(wanted, slide.blocked->normal) < 0)) return;
    const double top = state_.takeOff + shape_.ledge * state_.height / shape_.stand.height;
    const Vec3d ahead = normalize(-horizontal(slide.blocked->normal));
    if (!(top > state_.feet.z) || ahead == Vec3d{}) return;
    Box3d way = b.box(state_.feet);
    way.hi.z += top - state_.feet.z;
    const Body climber(nearLedge_.in(way.grown(b.reach() + 2 * kMargin)), shape_, state_.height);
    const auto ledge = findLedge(climber, state_.feet, ahead, top);
    if (!ledge) return;
    state_.climbing = true;
    state_.ledge = *ledge;
    state_.velocity = {};
}

void Walker::climb(MotionTrail* trail) {
    const Body b = body(state_.height);
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
    if (trail != nullptr) trail->push_back(state_.feet);
    const bool arrived = !rising && length(way) - travel < kThere;
    if (arrived || travel < kThere / 10) {
        state_.climbing = false;
        state_.sinceJump = kForgetTicks;
    }
}

/// Decides whether the player stands, and draws it down to the floor that it walks on.
void Walker::settle(bool wasGrounded, MotionTrail* trail) {
    const bool rising = state_.velocity.z > 0;
    const bool justJumped = state_.sinceJump < kFreeOfFloorTicks;
    const double step = shape_.of(state_.stance).step;
    const Body b = body(state_.height);
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
        if (trail != nullptr && down > 0) trail->push_back(state_.feet);
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

/// After a step the eye follows without a jerk, drawn by a critically damped spring: below its place inside
/// the body, above it only as far as there is room.
void Walker::easeEye() {
    double& offset = state_.eyeOffset;
    double& speed = state_.eyeSpeed;
    const double pull = (speed + kEyeRate * offset) * kTickSeconds;
    offset = (offset + pull) * kEyeDecay;
    speed = (speed - kEyeRate * pull) * kEyeDecay;
    constexpr double kInvisible = 1e-4;
    if (std::fabs(offset) < kInvisible && std::fabs(speed) < kInvisible * kEyeRate) offset = speed = 0;
    const double lowest = shape_.radius + shape_.skin + shape_.eyeBelowTop - state_.height;
    if (offset < std::min(lowest, 0.0)) {
        offset = std::min(lowest, 0.0);
        speed = std::max(speed, 0.0);
    }
    if (!(offset > 0)) return;
    const UprightLine place{state_.feet + kUp * (state_.height - shape_.eyeBelowTop), 0};
    const double room =
        sweepCapsule(triangles_, place, shape_.eyeClearance - shape_.skin / 2, shape_.skin / 2, kUp, offset)
            .travel;
    if (room < offset) speed = std::min(speed, 0.0);
    offset = room;
}

// --- falling out of the world ---------------------------------------------------------------------------

void Walker::savePose() {
    sinceSaved_ = later(sinceSaved_);
    if (!state_.grounded || sinceSaved_ < kSaveTicks) return;
    sinceSaved_ = 0;
    saved_[static_cast<std::size_t>(savedNext_)] = {state_.feet, state_.height, state_.stance};
    savedNext_ = (savedNext_ + 1) % static_cast<int>(saved_.size());
    savedCount_ = std::min(savedCount_ + 1, static_cast<int>(saved_.size()));
}

bool Walker::restorePose() {
    // After another fall at once an older position is used, since each is used only once.
    if (savedCount_ == 0) return false;
    savedNext_ = (savedNext_ + static_cast<int>(saved_.size()) - 1) % static_cast<int>(saved_.size());
    --savedCount_;
    settled_ = false;
    const Pose& pose = saved_[static_cast<std::size_t>(savedNext_)];
    state_ = {};
    state_.feet = pose.feet;
    state_.height = pose.height;
    state_.stance = pose.stance;
    sinceSaved_ = 0;
    gather(0);
    return true;
}

} // namespace rtcore
