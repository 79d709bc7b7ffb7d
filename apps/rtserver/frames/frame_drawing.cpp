#include "rtserver/frames/frame_drawing.h"

#include "rtserver/frames/frame_detail.h"

#include "rtcore/platform/sentence.h"
#include "rtcore/render/frame_renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <utility>

namespace rtserver {

namespace {

using namespace std::chrono_literals;

constexpr auto kObstruction = 10s; ///< for a frame that a client waits for that has sent more commands
constexpr auto kMemoryPause = 1s;  ///< between frames for which there is no memory

std::string sizeText(const rtcore::RenderSettings& settings) {
    return fmt::format("{} x {}", settings.width, settings.height);
}

} // namespace

FrameDrawing::FrameDrawing(Workspace& state, SceneUpkeep& upkeep, Outlets outlets, int threads,
                           double framesPerSecond)
    : state_(state), upkeep_(upkeep), outlets_(std::move(outlets)), frames_(threads), pacer_(framesPerSecond),
      guard_([this] { return guardFrame(); }) {}

// --- Which frame is wanted ---

void FrameDrawing::noticePause(bool waitedFor) {
    keepsImage_ = state_.paused && (keepsImage_ || !wantsFrame(waitedFor));
}

bool FrameDrawing::wantsFrame(bool waitedFor) const {
    if (!state_.document.ready() || keepsImage_) return false;
    if (frames_.stale(state_.document) || wantsWholeFrame(waitedFor)) return true;
    return !state_.paused && (!frames_.settled() || !state_.idles);
}

// All pixels for an unchanged view, and for commands that write the frame to a file.
bool FrameDrawing::wantsWholeFrame(bool waitedFor) const {
    if (waitedFor && state_.wantsExact && !frames_.exact()) return true;
    return !frames_.complete() && (standsStill() || waitedFor);
}

bool FrameDrawing::idle() const {
    return state_.document.ready() && state_.idles && !frames_.stale(state_.document) && frames_.settled() &&
           frames_.complete() && state_.walk.atRest() && !upkeep_.loads();
}

double FrameDrawing::wholeSeconds() const {
    if (!tracesWhole_) return wholeSeconds_;
    return std::max(wholeSeconds_, std::chrono::duration<double>(Clock::now() - begun_).count());
}

bool FrameDrawing::takeChange() { return std::exchange(arrivals_.change, false); }

SceneUpkeep::Pace FrameDrawing::pace() {
    noticeScene();
    const bool current = !frames_.stale(state_.document);
    return {.current = current,
            .complete = current && frames_.complete(),
            .idle = idle(),
            .seconds = frames_.seconds(),
            .coarsest = schedule_.coarsest(),
            .wanted = state_.frameSeconds,
            .now = std::chrono::duration<double>(Clock::now().time_since_epoch()).count()};
}

// --- Drawing it ---

FrameDrawing::Drawn FrameDrawing::draw(bool waitedFor) {
    try {
        return drawFrame(waitedFor);
    } catch (const std::bad_alloc&) {
        tracesWhole_ = false;
        if (!drewWhole_) throw; // there is nothing to go back to
        return goBack();
    }
}

FrameDrawing::Drawn FrameDrawing::drawFrame(bool waitedFor) {
    const bool traces = frames_.stale(state_.document) || wantsWholeFrame(waitedFor) || !state_.idles ||
                        !frames_.hasRadiance();
    const Outcome outcome = traces ? trace(waitedFor) : Outcome::Published;
    // A setting with which no frame is ever finished must remain changeable.
    if (outcome == Outcome::Obstructed)
        return {
            outcome,
            rtcore::say("given up: the frame that it needs takes too long for the commands behind it; send "
                        "them later")};
    if (outcome != Outcome::Published) return {outcome};
    frames_.develop(state_.document);
    publish();
    noticePause(waitedFor); // before a command that is sent for what has just been seen
    if (traces) schedule_.shown(Clock::now() - begun_, frames_.liveCost());
    return {};
}

// The effect of an edit on the time of a frame is learned from the next few frames; but of another scene
// nothing is known.
void FrameDrawing::noticeScene() {
    if (!scheduled_.take(state_.document.revisions()).has(rtcore::Change::Scene)) return;
    schedule_.forget();
    wholeSeconds_ = 0;
}

FrameSchedule::Demand FrameDrawing::demand(bool waitedFor, const rtcore::ShadowMaps* maps) {
    const rtcore::Scene& scene = *state_.document.imagedScene();
    const rtcore::RenderSettings& settings = state_.document.settings();
    const bool mapped = maps != nullptr && maps->suit(settings);
    const bool changed = frames_.stale(state_.document) || (!standsStill() && !waitedFor);
    return {.changed = changed,
            .waitedFor = waitedFor,
            .frameSeconds = state_.frameSeconds,
            .work = {workOf(settings, scene), workOf(settingsAt(settings, {1, true}), scene, mapped)},
            .live = (changed || schedule_.owes()) && frames_.drawsLive(state_.document),
            .pixels = static_cast<double>(settings.width) * settings.height,
            .liveRays = liveRays(settings, scene)};
}

/// Of a whole frame. Where all frames are whole, those of a moving camera show what the walk knows.
IndirectOf FrameDrawing::indirectLight(bool waitedFor) const {
    const bool live = state_.document.settings().indirect.mode == rtcore::IndirectMode::Live;
    if (!live || state_.wantsExact) return IndirectOf::View;
    if (!standsStill() && !waitedFor) return IndirectOf::Walk;
    return state_.restsInWalkLight && state_.frameSeconds > 0 ? IndirectOf::Rest : IndirectOf::View;
}

FrameDrawing::Outcome FrameDrawing::trace(bool waitedFor) {
    noticeScene();
    const rtcore::ShadowMaps* const maps = upkeep_.shadowMaps();
    FrameDetail detail = schedule_.begin(demand(waitedFor, maps));
    if (detail.whole()) detail.indirect = indirectLight(waitedFor);
    begun_ = Clock::now();
    tracesWhole_ = detail.whole();
    stepDue_ = begun_ + pacer_.interval();
    arrivals_ = {};
    rtcore::RenderControl control;
    bool done = false;
    {
        const FrameGuard::Watch watch(guard_, control.cancel);
        done = frames_.trace(state_, detail, maps, control);
    }
    tracesWhole_ = false;
    if (guardError_) std::rethrow_exception(std::exchange(guardError_, nullptr));
    if (done && detail.whole()) wholeSeconds_ = frames_.seconds();
    if (done) return Outcome::Published;
    schedule_.left(Clock::now() - begun_);
    return arrivals_.obstructed ? Outcome::Obstructed : Outcome::Left;
}

// In the guard's thread.
bool FrameDrawing::guardFrame() {
    if (guardError_) return true;
    try {
        const Arrivals news = outlets_.poll();
        const Clock::duration lasted = Clock::now() - begun_;
        arrivals_.change = arrivals_.change || news.change;
        arrivals_.end = arrivals_.end || news.end;
        arrivals_.obstructed = news.obstructed && lasted > kObstruction;
        if (arrivals_.end || arrivals_.obstructed || schedule_.leaves(lasted, arrivals_.change)) return true;
        publishStep();
        return false;
    } catch (...) {
        guardError_ = std::current_exception();
        return true;
    }
}

// In the guard's thread. Not more often than frames may come.
void FrameDrawing::publishStep() {
    const Clock::time_point now = Clock::now();
    if (now < stepDue_) return;
    const rtcore::LdrImage* const image = frames_.underWay(state_.document);
    if (image == nullptr) return;
    publish(*image, 0);
    stepDue_ = now + pacer_.interval();
}

void FrameDrawing::publish(const rtcore::LdrImage& image, std::uint32_t samples) {
    ipc::FrameInfo info;
    info.width = static_cast<std::uint32_t>(image.width);
    info.height = static_cast<std::uint32_t>(image.height);
    info.samples = samples;
    outlets_.publish(info, image);
}

void FrameDrawing::publish() {
    const auto side = static_cast<std::uint32_t>(state_.document.settings().antialiasing);
    publish(frames_.image(), frames_.whole() ? side * side : 0);
    if (frames_.whole()) {
        drawn_ = state_.document.settings();
        drewWhole_ = true;
        wentBack_ = false;
    }
    pacer_.published(begun_, Clock::now());
}

// --- Without memory ---

FrameDrawing::Drawn FrameDrawing::goBack() {
    rtcore::Sentence why = rtcore::say("not enough memory for frames of {0} at these settings; back to those "
                                       "of the last frame, {1}",
                                       sizeText(state_.document.settings()), sizeText(drawn_));
    frames_.drop();
    state_.document.goBackTo(drawn_);
    // Even those may need more than there is now. The last frame stands, and memory may come back.
    if (std::exchange(wentBack_, true)) pacer_.pauseUntil(Clock::now() + kMemoryPause);
    return {Outcome::NoMemory, std::move(why)};
}

} // namespace rtserver
