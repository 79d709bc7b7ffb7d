#include "rtserver/resolution_governor.h"

#include <algorithm>
#include <cmath>

namespace rtserver {

namespace {
constexpr double kLeast = 0.125;
constexpr double kSteps = 16;
constexpr double kBack = 0.15; ///< share of the way up that is taken after each frame
} // namespace

void ResolutionGovernor::learn(double seconds, double scale, double target) {
    if (!(seconds > 0)) return;
    const double fits = std::clamp(scale * std::sqrt(target / seconds), kLeast, 1.0);
    wanted_ = fits < wanted_ ? fits : wanted_ + (fits - wanted_) * kBack;
}

double ResolutionGovernor::scale() const {
    constexpr double kRounding = 1e-3;
    return std::max(kLeast, std::floor(wanted_ * kSteps + kRounding) / kSteps);
}

} // namespace rtserver
