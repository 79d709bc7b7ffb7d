#include "rtcore/motion/player.h"

#include "rtcore/motion/clearance.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr std::int64_t kLongest = kSecond / 4;

double flyingSpeedIn(const Box3& bounds, double metresPerUnit) {
    constexpr double kFraction = 0.1;
    const double speed = kFraction * double{bounds.diagonal()} * metresPerUnit;
    return speed > 0 && std::isfinite(speed) ? speed : 1;
}

double between(double a, double b, double fraction) { return a + (b - a) * fraction; }

} // namespace

Player::Player(const KdTree& tree, const Mesh& mesh, const PlayerOptions& options)
    : tree_(&tree), mesh_(mesh), frame_(options.up, options.metresPerUnit),
      walker_(tree, mesh, frame_, WalkShape(options.walk)),
      flyingSpeed_(flyingSpeedIn(tree.bounds, frame_.metresPerUnit())) {
    Camera camera;
    camera.forward = frame_.turnBack({0, 1, 0});
    camera.up = frame_.up();
    setCamera(camera);
}

void Player::useTree(const KdTree& tree) {
    tree_ = &tree;
    walker_.useTree(tree);
}

void Player::setCamera(const Camera& camera) {
    given_ = camera;
    pace_ = 0;
    moved_ = turned_ = narrowed_ = false;
    flight_ = {frame_.toMetres(camera.eye), {}};
    if (camera.kind == CameraKind::Orthographic) flight_.width = double{camera.orthographicWidth};
    turn_ = {};
    now_ = {flight_.eye, headingOf(frame_.turn(camera.forward), frame_.turn(camera.up)), flight_.width};
    before_ = now_;
    if (mode_ == MotionMode::View) return;
    mode_ = MotionMode::View;
    setMode(MotionMode::Walk);
}

Camera Player::camera() const {
    Camera camera = given_;
    const double fraction = static_cast<double>(clock_) / kSecond;
    if (moved_) camera.eye = frame_.toScene(before_.eye + (now_.eye - before_.eye) * fraction);
    if (turned_) {
        const Heading heading{between(before_.heading.yaw, now_.heading.yaw, fraction),
                              between(before_.heading.pitch, now_.heading.pitch, fraction)};
        camera.forward = frame_.turnBack(lookDirection(heading));
        camera.up = frame_.up();
    }
    if (narrowed_)
        camera.orthographicWidth = static_cast<float>(between(before_.width, now_.width, fraction));
    return camera;
}

bool Player::setMode(MotionMode mode) {
    if (mode == mode_) return true;
    if (mode == MotionMode::Walk) {
        if (!walker_.enter(now_.eye)) return false;
        entered_ = now_.eye;
        moved_ = moved_ || walker_.eye() != now_.eye;
        // It may have been put aside: drawn there at once.
        constexpr double kAside = 1e-6;
        if (length(walker_.eye() - now_.eye) > kAside) now_.eye = walker_.eye();
    }
    flight_ = {now_.eye, {}, now_.width};
    before_ = now_;
    mode_ = mode;
    return true;
}

void Player::look(double right, double upwards) {
    if (!std::isfinite(right) || !std::isfinite(upwards) || (right == 0 && upwards == 0)) return;
    const Heading old = now_.heading;
    now_.heading = normalize(Heading{old.yaw - right, old.pitch + upwards});
    before_.heading.yaw += now_.heading.yaw - old.yaw;
    before_.heading.pitch =
        std::clamp(before_.heading.pitch + (now_.heading.pitch - old.pitch), -kMaxPitch, kMaxPitch);
    turned_ = true;
}

void Player::advance(std::chrono::nanoseconds time) {
    clock_ += std::clamp<std::int64_t>(time.count(), 0, kLongest) * kTicksPerSecond;
    for (; clock_ >= kSecond; clock_ -= kSecond) step();
}

void Player::step() {
    before_ = now_;
    const ActionSet held = held_ | tapped_;
    tapped_ = {};
    Heading heading = now_.heading;
    turn(turn_, heading, held);
    const Heading wrapped = normalize(heading);
    before_.heading.yaw += wrapped.yaw - heading.yaw;
    now_.heading = wrapped;
    turned_ = turned_ || turn_ != TurnState{};
    if (mode_ == MotionMode::Walk) {
        stepWalking(held);
    } else {
        stepFlying(held);
    }
    narrowed_ = narrowed_ || now_.width != before_.width;
    moved_ = moved_ || now_.eye != before_.eye;
}

void Player::stepWalking(const ActionSet& held) {
    WalkInput input;
    input.ahead = aheadOf(now_.heading);
    input.forward = held.balance(Action::Forward, Action::Back);
    input.right = held.balance(Action::Right, Action::Left);
    input.jump = held.has(Action::Jump);
    input.crouch = held.has(Action::Crouch);
    input.crawl = held.has(Action::Crawl);
    input.sprint = held.has(Action::Sprint);
    const bool inWorld = walker_.tick(input);
    now_.eye = inWorld ? walker_.eye() : entered_;
    if (inWorld) return;
    flight_ = {now_.eye, {}, now_.width};
    mode_ = MotionMode::View;
}

// A room is crossed slowly, whatever else the scene has.
void Player::stepFlying(const ActionSet& held) {
    constexpr double kPerSecond = 1, kSlowest = 0.3; // m/s
    constexpr double kFollow = 4 * kTickSeconds;
    if (!held.none() || flight_.velocity != Vec3d{}) {
        const double here = kPerSecond * clearance(*tree_, mesh_, frame_, now_.eye);
        const double wanted = std::min(flyingSpeed_, std::max(here, kSlowest));
        pace_ = pace_ > 0 ? pace_ + (wanted - pace_) * kFollow : wanted;
    }
    fly(flight_, now_.heading, held, pace_ * speedFactor_);
    now_.eye = flight_.eye;
    now_.width = flight_.width;
}

bool Player::atRest() const {
    if (!held_.none() || !tapped_.none() || turn_ != TurnState{} || before_ != now_) return false;
    return mode_ == MotionMode::Walk ? walker_.atRest()
                                     : flight_.velocity == Vec3d{} && flight_.narrowing == 0;
}

} // namespace rtcore
