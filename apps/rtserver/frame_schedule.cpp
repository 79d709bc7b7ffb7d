#include "rtserver/frame_schedule.h"

namespace rtserver {

namespace {

constexpr auto kLongFrame = std::chrono::seconds(1);

double seconds(FrameSchedule::Duration time) { return std::chrono::duration<double>(time).count(); }

} // namespace

FrameDetail FrameSchedule::choose() const {
    if (owed_) return kCoarsest;
    if (!demand_.changed || demand_.frameSeconds <= 0) return {};
    return governor_.detail(demand_.work, demand_.frameSeconds);
}

FrameDetail FrameSchedule::begin(const Demand& demand) {
    demand_ = demand;
    detail_ = choose();
    return detail_;
}

bool FrameSchedule::leaves(Duration lasted, bool changeWaits) const {
    if (detail_ == kCoarsest) return false;
    const bool patient = demand_.waitedFor || demand_.frameSeconds <= 0;
    if (demand_.changed && demand_.frameSeconds > 0) return seconds(lasted) > demand_.frameSeconds;
    return changeWaits && (!patient || lasted > kLongFrame);
}

void FrameSchedule::left(Duration lasted) {
    owed_ = demand_.changed || demand_.frameSeconds <= 0;
    governor_.learnLimit(detail_, demand_.work, seconds(lasted));
}

void FrameSchedule::shown(Duration lasted) {
    owed_ = false;
    governor_.learn(detail_, demand_.work, seconds(lasted));
}

void FrameSchedule::forget() {
    governor_.forget();
    owed_ = false;
}

} // namespace rtserver
