#include "rtserver/adaptation.h"

#include <cmath>

namespace rtserver {

namespace {
constexpr double kNear = 0.004; ///< in the logarithm: a fifth of a step of eight bits
} // namespace

void Adaptation::jump(float target) {
    value_ = target;
    settled_ = true;
}

float Adaptation::advance(float target, double seconds, const AdaptationSpeed& speed) {
    const double from = std::log(static_cast<double>(value_.value_or(target)));
    const double to = std::log(static_cast<double>(target));
    const double speedSeconds = to > from ? speed.brighter : speed.darker;
    const double kept = speedSeconds > 0 ? std::exp(-std::fmax(seconds, 0) / speedSeconds) : 0;
    const double left = (to - from) * kept;
    settled_ = !(std::fabs(left) > kNear);
    value_ = settled_ ? target : static_cast<float>(std::exp(to - left));
    return *value_;
}

} // namespace rtserver
