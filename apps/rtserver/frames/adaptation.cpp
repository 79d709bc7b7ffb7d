#include "rtserver/frames/adaptation.h"

#include <algorithm>
#include <cmath>

namespace rtserver {

namespace {

// In the logarithm of the exposure.
constexpr double kNear = 0.0005;          ///< too little to be seen
constexpr double kMinSpeed = 0.12;        ///< per second
constexpr double kMinSpeedOfRange = 0.05; ///< per time constant

/// The rest of a distance after `seconds`: it falls to 1/e in each time constant, but never slower than at
/// the least speed, so that there is an end.
double leftOf(double distance, double seconds, double timeConstant) {
    if (timeConstant <= 0) return 0;
    const double min = std::min(kMinSpeed, kMinSpeedOfRange / timeConstant);
    const double slow = min * timeConstant; // the distance at which that speed is reached
    const double until = distance > slow ? std::min(timeConstant * std::log(distance / slow), seconds) : 0;
    const double there = distance * std::exp(-until / timeConstant);
    return std::max(there - min * (seconds - until), 0.0);
}

} // namespace

void Adaptation::jump(float target) {
    value_ = target;
    settled_ = true;
}

float Adaptation::advance(float target, double seconds, const AdaptationSpeed& speed) {
    const double from = std::log(static_cast<double>(value_.value_or(target)));
    const double to = std::log(static_cast<double>(target));
    const double left =
        leftOf(std::fabs(to - from), std::fmax(seconds, 0), to > from ? speed.brighter : speed.darker);
    settled_ = !(left > kNear);
    value_ = settled_ ? target : static_cast<float>(std::exp(to - std::copysign(left, to - from)));
    return *value_;
}

} // namespace rtserver
