#include "rtserver/frames/detail_governor.h"

#include <algorithm>
#include <cmath>

namespace rtserver {

namespace {

constexpr double kSteps = 16;
constexpr double kBack = 0.15;   ///< fraction of the way up that is taken after each frame
constexpr double kSpared = 0.65; ///< of the time: frames are not all alike
constexpr double kFine = 0.5;    ///< rather this scale with all samples than a finer one with few

double fits(double pace, double work, double target) {
    return std::min(1.0, pace * std::sqrt(target * kSpared / std::max(work, 1.0)));
}

double inSteps(double scale) {
    constexpr double kRounding = 1e-3;
    return std::max(kMinScale, std::floor(scale * kSteps + kRounding) / kSteps);
}

double paceAt(const FrameDetail& detail, const DetailGovernor::Work& work, double seconds) {
    const double done = detail.cut ? work.cut : work.whole;
    return detail.scale * std::sqrt(std::max(done, 1.0) / seconds);
}

} // namespace

FrameDetail DetailGovernor::detail(const Work& work, double target) const {
    if (fits(wholePace_, work.whole, target) == 1) return {};
    const double all = fits(pace_, work.whole, target);
    if (all >= kFine || work.cut >= work.whole) return {inSteps(all), false};
    return {inSteps(fits(pace_, work.cut, target)), true};
}

void DetailGovernor::learn(const FrameDetail& detail, const Work& work, double seconds) {
    if (!(seconds > 0)) return;
    const double now = paceAt(detail, work, seconds);
    double& pace = paceOf(detail);
    pace = pace == 0 || now < pace ? now : pace + (now - pace) * kBack;
}

void DetailGovernor::learnLimit(const FrameDetail& detail, const Work& work, double seconds) {
    if (!(seconds > 0)) return;
    const double max = paceAt(detail, work, seconds);
    double& pace = paceOf(detail);
    if (pace > max) pace = max;
}

} // namespace rtserver
