#include "rtserver/frames/live_governor.h"

#include <algorithm>
#include <cmath>

namespace rtserver {

namespace {

constexpr double kFilled = 0.85;                                 ///< of the time: frames are not all alike
constexpr double kSecondsPerRay = 1e-6, kSecondsPerPixel = 1e-7; ///< guesses
constexpr double kMinSamples = 0.004, kMaxSamples = 1;           ///< of the pixels of a frame
constexpr double kWantedSamples = 0.02;                          ///< of them: for these the size gives way
constexpr double kStep = 1.0 / 12;                               ///< of the scale
constexpr double kGrows = 0.9; ///< of the time, in which a larger frame must fit before there is one

/// Quick to believe in more, slow to believe in less.
void follow(double& known, double now) {
    constexpr double kUp = 0.5, kDown = 0.15;
    known = known == 0 ? now : known + (now - known) * (now > known ? kUp : kDown);
}

double area(double scale) { return scale * scale; }

} // namespace

FrameDetail LiveGovernor::detail(double pixels, double rays, double target) const {
    const double count = pixels * area(scale_);
    const double sample = secondsPerSample_ > 0 ? secondsPerSample_ : rays * kSecondsPerRay;
    const double pixel = secondsPerPixel_ > 0 ? secondsPerPixel_ : kSecondsPerPixel;
    const double left = std::max(target * kFilled - count * pixel, 0.0);
    // Few samples of a scene that nothing is known of: its frame is never left.
    constexpr double kFirst = 0.5, kFirstSamples = 64;
    const double first = std::min(kMinSamples, std::max(kFirst * target / sample, kFirstSamples) / count);
    const double min = secondsPerSample_ > 0 ? kMinSamples : first;
    return {scale_, true, std::clamp(left / (sample * count), min, kMaxSamples)};
}

void LiveGovernor::learn(const FrameDetail& detail, double pixels, double target, const Cost& cost) {
    const double count = pixels * area(detail.scale);
    if (cost.samples > 0) follow(secondsPerSample_, cost.sampleSeconds / cost.samples);
    follow(secondsPerPixel_, std::max(cost.seconds - cost.sampleSeconds, 0.0) / count);
    if (!(target > 0)) return;
    const auto minSeconds = [&](double scale) {
        return pixels * area(scale) * (secondsPerPixel_ + kWantedSamples * secondsPerSample_);
    };
    if (minSeconds(scale_) > target) {
        scale_ = std::max(kMinLiveScale, scale_ - kStep);
    } else if (scale_ < 1 && minSeconds(scale_ + kStep) < kGrows * target) {
        scale_ = std::min(1.0, scale_ + kStep);
    }
}

} // namespace rtserver
