#include "rtserver/frames/frame_schedule.h"

#include <algorithm>

namespace rtserver {

namespace {

constexpr auto kLongFrame = std::chrono::seconds(1);
constexpr double kNotDrawing = 0.4; ///< frame times in which a change is noticed and a frame is left
constexpr double kMin = 0.25;       ///< frame times; in less no other frame than the coarsest is tried
/// Fraction of a frame time for the first live frame after a whole one: nearly all that it shows is known,
/// and where nothing goes on moving the next whole frame comes the sooner.
constexpr double kGlimpse = 0.5;
constexpr double kForget = 0.05; ///< fraction of the way down that is taken after each coarsest frame

bool isCoarsest(const FrameDetail& detail) {
    return detail.cut && !detail.live() && detail.scale == kMinScale;
}

double seconds(FrameSchedule::Duration time) { return std::chrono::duration<double>(time).count(); }

} // namespace

FrameDetail FrameSchedule::choose() const {
    if (demand_.live && demand_.frameSeconds > 0 && (owed_ || demand_.changed)) return chooseLive();
    if (owed_) return kCoarsest;
    if (!demand_.changed || demand_.frameSeconds <= 0) return {};
    const double time = patience();
    return time > 0 ? governor_.detail(demand_.work, time) : kCoarsest;
}

FrameDetail FrameSchedule::chooseLive() const {
    if (!owed_ && governor_.detail(demand_.work, demand_.frameSeconds).whole()) return {};
    const double time = rested_ ? kGlimpse * demand_.frameSeconds : demand_.frameSeconds;
    return liveGovernor_.detail(demand_.pixels, demand_.liveRays, time);
}

/// For a frame after a change, so that the coarsest is in time when it is left.
double FrameSchedule::patience() const {
    const double spare = (2 - kNotDrawing) * demand_.frameSeconds - coarsest_;
    return spare < kMin * demand_.frameSeconds ? 0 : std::min(spare, demand_.frameSeconds);
}

FrameDetail FrameSchedule::begin(const Demand& demand) {
    demand_ = demand;
    detail_ = choose();
    if (detail_.cut && !detail_.live() && demand_.frameSeconds > 0)
        detail_.learning = liveGovernor_.coarseLearning(demand_.frameSeconds);
    return detail_;
}

bool FrameSchedule::leaves(Duration lasted, bool changeWaits) const {
    if (isCoarsest(detail_) || detail_.live()) return false;
    const bool patient = demand_.waitedFor || demand_.frameSeconds <= 0;
    if (demand_.changed && demand_.frameSeconds > 0) return seconds(lasted) > patience();
    return changeWaits && (!patient || lasted > kLongFrame);
}

void FrameSchedule::left(Duration lasted) {
    owed_ = demand_.changed || demand_.frameSeconds <= 0;
    rested_ = false;
    if (detail_.live()) return;
    governor_.learnLimit(detail_, demand_.work, seconds(lasted));
}

void FrameSchedule::shown(Duration lasted, LiveGovernor::Cost live) {
    owed_ = false;
    rested_ = detail_.whole();
    if (isCoarsest(detail_)) {
        const double now = seconds(lasted);
        coarsest_ = now > coarsest_ ? now : coarsest_ + (now - coarsest_) * kForget;
    }
    if (detail_.live()) {
        live.seconds = seconds(lasted);
        liveGovernor_.learn(detail_, demand_.pixels, demand_.frameSeconds, live);
        return;
    }
    if (live.rays > 0) liveGovernor_.learnRays(live);
    governor_.learn(detail_, demand_.work, seconds(lasted));
}

void FrameSchedule::forget() {
    governor_.forget();
    liveGovernor_.forget();
    coarsest_ = 0;
    owed_ = rested_ = false;
}

} // namespace rtserver
