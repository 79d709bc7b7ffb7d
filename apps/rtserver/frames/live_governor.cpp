#include "rtserver/frames/live_governor.h"

#include "rtserver/frames/walk_light.h"

#include <algorithm>
#include <cmath>

namespace rtserver {

namespace {

constexpr double kFilled = 0.85;                                 ///< of the time: frames are not all alike
constexpr double kSecondsPerRay = 1e-6, kSecondsPerPixel = 1e-7; ///< guesses
constexpr double kMinSamples = 0.004, kMaxSamples = 1;           ///< of the pixels of a frame
constexpr double kWantedSamples = 0.02;                          ///< of them: for these the size gives way
constexpr double kMinLearning = 0.25;                            ///< of its rays
constexpr double kStep = 1.0 / 12;                               ///< of the scale
constexpr double kGrows = 0.9; ///< of the time, in which a larger frame must fit before there is one

/// Quick to believe in more, slow to believe in less.
void follow(double& known, double now) {
    constexpr double kUp = 0.5, kDown = 0.15;
    known = known == 0 ? now : known + (now - known) * (now > known ? kUp : kDown);
}

double area(double scale) { return scale * scale; }

} // namespace

/// All of the rays of a frame.
double LiveGovernor::learningSeconds() const { return WalkLight::kBudget.rays * secondsPerRay_; }

/// For a frame of that size in which all else has given way.
double LiveGovernor::minSeconds(double pixels, double scale) const {
    return pixels * area(scale) * (secondsPerPixel_ + kWantedSamples * secondsPerSample_) +
           kMinLearning * learningSeconds();
}

FrameDetail LiveGovernor::detail(double pixels, double rays, double target) const {
    const double count = pixels * area(scale_);
    const double sample = secondsPerSample_ > 0 ? secondsPerSample_ : rays * kSecondsPerRay;
    const double pixel = secondsPerPixel_ > 0 ? secondsPerPixel_ : kSecondsPerPixel;
    double left = std::max(target * kFilled - count * pixel, 0.0);
    const double all = learningSeconds(), forRays = left - kWantedSamples * sample * count;
    const double learning = forRays < all ? std::max(forRays / all, kMinLearning) : 1;
    left = std::max(left - learning * all, 0.0);
    // Few samples of a scene that nothing is known of: its frame is never left.
    constexpr double kFirst = 0.5, kFirstSamples = 64;
    const double first = std::min(kMinSamples, std::max(kFirst * target / sample, kFirstSamples) / count);
    const double min = secondsPerSample_ > 0 ? kMinSamples : first;
    return {scale_, true, std::clamp(left / (sample * count), min, kMaxSamples), learning};
}

void LiveGovernor::learn(const FrameDetail& detail, double pixels, double target, const Cost& cost) {
    const double count = pixels * area(detail.scale);
    if (cost.samples > 0) follow(secondsPerSample_, cost.sampleSeconds / cost.samples);
    if (cost.rays > 0) {
        follow(secondsPerRay_, cost.raySeconds / cost.rays);
    } else {
        secondsPerRay_ = 0;
    }
    follow(secondsPerPixel_, std::max(cost.seconds - cost.sampleSeconds - cost.raySeconds, 0.0) / count);
    if (!(target > 0)) return;
    if (minSeconds(pixels, scale_) > target) {
        scale_ = std::max(kMinLiveScale, scale_ - kStep);
    } else if (scale_ < 1 && minSeconds(pixels, scale_ + kStep) < kGrows * target) {
        scale_ = std::min(1.0, scale_ + kStep);
    }
}

} // namespace rtserver
