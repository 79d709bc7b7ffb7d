#include "rtserver/flying.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rtserver {

namespace {

using rtcore::Vec3;

constexpr float kDiagonalsPerSecond = 0.12F;
constexpr float kSprint = 4;
constexpr float kDegreesPerSecond = 90;
constexpr float kSteepest = 89; ///< degrees from level, so that `up` never is parallel to the view

float radians(float degrees) { return degrees * std::numbers::pi_v<float> / 180; }

// About a unit vector, counter-clockwise seen against it (Rodrigues).
Vec3 rotated(Vec3 v, Vec3 axis, float angle) {
    const float c = std::cos(angle), s = std::sin(angle);
    return v * c + cross(axis, v) * s + axis * (dot(axis, v) * (1 - c));
}

} // namespace

Flyer::Flyer(const rtcore::Camera& camera, const rtcore::Box3& bounds, Vec3 up)
    : camera_(camera), up_(up),
      unitsPerSecond_(bounds.diagonal() > 0 ? bounds.diagonal() * kDiagonalsPerSecond : 1) {}

float Flyer::axis(Action positive, Action negative) const {
    return (pressed(positive) ? 1.0F : 0.0F) - (pressed(negative) ? 1.0F : 0.0F);
}

void Flyer::look(float right, float upwards) {
    Vec3 forward = normalize(camera_.forward);
    if (upwards != 0) {
        const float level = std::acos(std::clamp(dot(forward, normalize(camera_.up)), -1.0F, 1.0F));
        const float height = 90 - level * 180 / std::numbers::pi_v<float>;
        const float wanted =
            std::clamp(height + upwards, std::min(height, -kSteepest), std::max(height, kSteepest));
        forward = rotated(forward, normalize(cross(forward, camera_.up)), radians(wanted - height));
    }
    if (right != 0) {
        forward = rotated(forward, up_, radians(-right));
        // A camera that leans keeps leaning; another one keeps its `up` to the bit.
        if (camera_.up != up_) camera_.up = rotated(camera_.up, up_, radians(-right));
    }
    camera_.forward = normalize(forward);
}

bool Flyer::advance(double seconds) {
    if (pressed_.none() || !(seconds > 0)) return false;
    const auto time = static_cast<float>(seconds);
    const rtcore::Camera before = camera_;
    const float right = axis(Action::TurnRight, Action::TurnLeft);
    const float upwards = axis(Action::TurnUp, Action::TurnDown);
    if (right != 0 || upwards != 0)
        look(right * kDegreesPerSecond * time, upwards * kDegreesPerSecond * time);

    const Vec3 forward = normalize(camera_.forward);
    const Vec3 sideways = normalize(cross(forward, camera_.up));
    const Vec3 way = forward * axis(Action::Forward, Action::Back) +
                     sideways * axis(Action::Right, Action::Left) + up_ * axis(Action::Up, Action::Down);
    const float speed = unitsPerSecond_ * (pressed(Action::Sprint) ? kSprint : 1.0F);
    camera_.eye += normalize(way) * (speed * time);
    return camera_ != before;
}

} // namespace rtserver
