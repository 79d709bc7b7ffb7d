#include "rtcore/motion/walk_shape.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

double sensible(float value, double lo, double hi, float otherwise) {
    return std::isfinite(value) ? std::clamp(double{value}, lo, hi) : double{otherwise};
}

} // namespace

WalkShape::WalkShape(const WalkParameters& p) {
    const WalkParameters usual;
    const double height = sensible(p.height, 0.05, 100, usual.height);
    const double speed = sensible(p.speed, 0.01, 100, usual.speed);
    const double step = sensible(p.stepHeight, 0, height / 2, usual.stepHeight);
    const double jump = sensible(p.jumpHeight, 0, 100, usual.jumpHeight);
    const double k = height / 1.8;
    stand = {height, step, speed, jump};
    crouch = {1.1 * k, 0.75 * step, speed / 2, jump / 2};
    crawl = {0.6 * k, 0.375 * step, speed * 0.27, 0};
    radius *= k;
    skin *= k;
    eyeBelowTop *= k;
    eyeClearance *= k;
    ledge *= k;
    climbSpeed *= k;
    gravity = sensible(p.gravity, 0, 1000, usual.gravity);
    groundForce *= std::max(1.0, speed / 3);
    stanceRate *= k;
}

} // namespace rtcore
