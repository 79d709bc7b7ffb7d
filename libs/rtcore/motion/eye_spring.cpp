#include "rtcore/motion/eye_spring.h"

#include "rtcore/motion/sweep.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

constexpr double kEyeRate = 20;      ///< 1/s; of the spring that draws the eye back to its place
constexpr double kEyeDecay = 0.8465; ///< e^(-kEyeRate * kTickSeconds)

} // namespace

void easeEye(const WalkShape& shape, std::span<const SolidTriangle> triangles, WalkState& state) {
    double& offset = state.eyeOffset;
    double& speed = state.eyeSpeed;
    const double pull = (speed + kEyeRate * offset) * kTickSeconds;
    offset = (offset + pull) * kEyeDecay;
    speed = (speed - kEyeRate * pull) * kEyeDecay;
    constexpr double kInvisible = 1e-4;
    if (std::fabs(offset) < kInvisible && std::fabs(speed) < kInvisible * kEyeRate) offset = speed = 0;
    const double lowest = shape.radius + shape.skin + shape.eyeBelowTop - state.height;
    if (offset < std::min(lowest, 0.0)) {
        offset = std::min(lowest, 0.0);
        speed = std::max(speed, 0.0);
    }
    if (!(offset > 0)) return;
    constexpr Vec3d up{0, 0, 1};
    const UprightLine place{state.feet + up * (state.height - shape.eyeBelowTop), 0};
    const double room =
        sweepCapsule(triangles, place, shape.eyeClearance - shape.skin / 2, shape.skin / 2, up, offset)
            .travel;
    if (room < offset) speed = std::min(speed, 0.0);
    offset = room;
}

} // namespace rtcore
