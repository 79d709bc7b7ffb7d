#include "rtserver/frames/frame_pacer.h"

#include <algorithm>
#include <utility>

namespace rtserver {

namespace {

using namespace std::chrono_literals;

constexpr auto kAdaptationStep = 16ms;

} // namespace

FramePacer::Clock::duration FramePacer::interval() const {
    if (framesPerSecond_ <= 0) return {};
    return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1 / framesPerSecond_));
}

void FramePacer::published(Clock::time_point begun, Clock::time_point now) {
    published_.push_back(now);
    while (now - published_.front() > 1s) published_.pop_front();

    due_ = now;
    adapted_ = now + kAdaptationStep;
    if (framesPerSecond_ <= 0) return;
    // One that was late does not put off all that follow: they keep their beat.
    constexpr int kPause = 5; // intervals
    const auto late = (begun - beat_) / interval();
    beat_ = (late < kPause ? beat_ + late * interval() : begun) + interval();
    due_ = std::max(due_, beat_);
}

double FramePacer::framesPerSecond(Clock::time_point now) const {
    return static_cast<double>(
        std::ranges::count_if(published_, [&](Clock::time_point then) { return now - then <= 1s; }));
}

} // namespace rtserver
