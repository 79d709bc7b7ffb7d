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
constexpr double kMinLearning = 0.25, kMaxLearning = rtcore::GatherBudget::kMaxTimes; ///< of its rays
constexpr double kCoarseRays = 0.5; ///< of the time of a coarse frame, whose pixels take little
constexpr double kStep = 1.0 / 12;  ///< of the scale
constexpr double kGrows = 0.9;      ///< of the time, in which a larger frame must fit before there is one

double area(double scale) { return scale * scale; }

} // namespace

/// Quick to believe in more, slow to believe in less; but the first frame has memory to fetch besides.
void LiveGovernor::Rate::learn(double now) {
    constexpr double kUp = 0.5, kDown = 0.15, kMaxTimes = 2;
    const auto [last, other] = before_;
    before_ = {now, last};
    if (other == 0) {
        known_ = last == 0 ? now : std::min(now, last);
        return;
    }
    const double likely = std::min(now, kMaxTimes * std::max(last, other));
    known_ += (likely - known_) * (likely > known_ ? kUp : kDown);
}

/// All of the rays of a frame.
double LiveGovernor::learningSeconds() const { return WalkLight::kBudget.rays * ray_.seconds(); }

/// For a frame of that size in which all else has given way.
double LiveGovernor::minSeconds(double pixels, double scale) const {
    return pixels * area(scale) * (pixel_.seconds() + kWantedSamples * sample_.seconds()) +
           kMinLearning * learningSeconds();
}

FrameDetail LiveGovernor::detail(double pixels, double rays, double target) const {
    const double count = pixels * area(scale_);
    const double sample = sample_.seconds() > 0 ? sample_.seconds() : rays * kSecondsPerRay;
    const double pixel = pixel_.seconds() > 0 ? pixel_.seconds() : kSecondsPerPixel;
    double left = std::max(target * kFilled - count * pixel, 0.0);
    const double all = learningSeconds(), forRays = left - kWantedSamples * sample * count;
    const double wanted = 1 + (kMaxLearning - 1) * unknown_;
    const double learning = forRays < wanted * all ? std::max(forRays / all, kMinLearning) : wanted;
    left = std::max(left - learning * all, 0.0);
    // Few samples of a scene that nothing is known of: its frame is never left.
    constexpr double kFirst = 0.5, kFirstSamples = 64;
    const double first = std::min(kMinSamples, std::max(kFirst * target / sample, kFirstSamples) / count);
    const double min = sample_.seconds() > 0 ? kMinSamples : first;
    return {scale_, true, std::clamp(left / (sample * count), min, kMaxSamples), learning};
}

double LiveGovernor::coarseLearning(double target) const {
    const double all = learningSeconds();
    return all > 0 ? std::clamp(kCoarseRays * target / all, kMinLearning, kMaxLearning) : 1;
}

void LiveGovernor::learnRays(const Cost& cost) {
    unknown_ = cost.unknown;
    if (cost.rays > 0) {
        ray_.learn(cost.raySeconds / cost.rays);
    } else {
        ray_ = {};
    }
}

void LiveGovernor::learn(const FrameDetail& detail, double pixels, double target, const Cost& cost) {
    const double count = pixels * area(detail.scale);
    if (cost.samples > 0) sample_.learn(cost.sampleSeconds / cost.samples);
    learnRays(cost);
    pixel_.learn(std::max(cost.seconds - cost.sampleSeconds - cost.raySeconds, 0.0) / count);
    if (!(target > 0)) return;
    if (minSeconds(pixels, scale_) > target) {
        scale_ = std::max(kMinLiveScale, scale_ - kStep);
    } else if (scale_ < 1 && minSeconds(pixels, scale_ + kStep) < kGrows * target) {
        scale_ = std::min(1.0, scale_ + kStep);
    }
}

} // namespace rtserver
