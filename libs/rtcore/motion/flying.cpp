#include "rtcore/motion/flying.h"

#include "rtcore/motion/walker.h"
#include "rtcore/simd/portable_math.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rtcore {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kInertia = 0.88; ///< what a step leaves of the difference: e^(-tick / 0.065 s)
constexpr double kTurnSpeed = 1.6;
constexpr double kStopped = 1e-3; ///< fraction of full speed that counts as rest

double sine(double x) { return double{portableSin(static_cast<float>(x))}; }
double cosine(double x) { return double{portableCos(static_cast<float>(x))}; }

double settle(double speed, double wanted, double full) {
    const double now = wanted + (speed - wanted) * kInertia;
    return std::fabs(now - wanted) < kStopped * full ? wanted : now;
}

/// In e-folds a second.
void narrow(FlightState& state, double wanted) {
    constexpr double kLog2E = 1.44269504088896340736, kNarrowest = 1e-9, kWidest = 1e15;
    state.narrowing = settle(state.narrowing, wanted, 1);
    const auto doublings = static_cast<float>(-state.narrowing * kTickSeconds * kLog2E);
    state.width = std::clamp(state.width * double{portableExp2(doublings)}, kNarrowest, kWidest);
}

} // namespace

Heading normalize(Heading h) {
    if (!std::isfinite(h.yaw)) h.yaw = 0;
    if (!std::isfinite(h.pitch)) h.pitch = 0;
    if (std::fabs(h.yaw) > kPi) h.yaw -= 2 * kPi * std::round(h.yaw / (2 * kPi));
    h.pitch = std::clamp(h.pitch, -kMaxPitch, kMaxPitch);
    return h;
}

Vec3d aheadOf(Heading h) { return normalize(Vec3d{-sine(h.yaw), cosine(h.yaw), 0}); }

Vec3d lookDirection(Heading h) {
    return normalize(aheadOf(h) * cosine(h.pitch) + Vec3d{0, 0, 1} * sine(h.pitch));
}

Heading headingOf(Vec3d forward, Vec3d up) {
    const Vec3d f = normalize(forward);
    const double across = length(horizontal(f));
    constexpr double kUpright = 1e-4;
    // Looking straight up or down, the top of the image tells the heading.
    const Vec3d ahead = across > kUpright ? f : f.z < 0 ? up : -up;
    const auto yaw = portableAtan2(static_cast<float>(-ahead.x), static_cast<float>(ahead.y));
    const auto pitch = portableAtan2(static_cast<float>(f.z), static_cast<float>(across));
    return normalize(Heading{double{yaw}, double{pitch}});
}

void fly(FlightState& state, Heading heading, const ActionSet& held, double speed) {
    const double pace = (held.has(Action::Sprint) ? 4 : 1) * (held.has(Action::Crouch) ? 0.25 : 1);
    const double full = speed * pace;
    const Vec3d ahead = aheadOf(heading);
    double forward = held.balance(Action::Forward, Action::Back);
    if (state.width > 0) {
        narrow(state, forward * pace);
        forward = 0;
    }
    const Vec3d wish = lookDirection(heading) * forward +
                       Vec3d{ahead.y, -ahead.x, 0} * held.balance(Action::Right, Action::Left) +
                       Vec3d{0, 0, 1} * held.balance(Action::Up, Action::Down);
    const Vec3d wanted = normalize(wish) * full;
    state.velocity = wanted + (state.velocity - wanted) * kInertia;
    if (length(state.velocity - wanted) < kStopped * speed) state.velocity = wanted;
    state.eye += state.velocity * kTickSeconds;
}

void turn(TurnState& state, Heading& heading, const ActionSet& held) {
    const double yaw = held.balance(Action::TurnLeft, Action::TurnRight) * kTurnSpeed;
    const double pitch = held.balance(Action::TurnUp, Action::TurnDown) * kTurnSpeed;
    state.yawSpeed = settle(state.yawSpeed, yaw, kTurnSpeed);
    state.pitchSpeed = settle(state.pitchSpeed, pitch, kTurnSpeed);
    heading.yaw += state.yawSpeed * kTickSeconds;
    heading.pitch += state.pitchSpeed * kTickSeconds;
}

} // namespace rtcore
