#include "rtserver/loop/server_loop.h"

#include "rtserver/commands/key_edits.h"
#include "rtserver/loop/server_status.h"

#include "common/process/stop.h"

#include "rtcore/io/text/sentence_json.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/raw_memory.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/platform/threads.h"
#include "rtcore/settings/plain_text.h"

#include <algorithm>
#include <span>
#include <utility>

namespace rtserver {

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr Clock::duration kSleep = 200ms; ///< less than a step of Walk::move() may last
constexpr Clock::duration kSleepAtWork = 20ms;
constexpr double kTold = 0.1;                  ///< seconds more of a whole frame that are told
constexpr Clock::duration kMotionStep = 2ms;   ///< until a moving camera has moved
constexpr Clock::duration kSideWorkStep = 2ms; ///< until a file that is written is asked for again

ipc::ServerOptions serverOptions(const Options& options) {
    ipc::ServerOptions result;
    result.instance = options.instance;
    return result;
}

} // namespace

ServerLoop::ServerLoop(const Options& options, std::function<void()> onReady)
    : options_(options), onReady_(std::move(onReady)), server_(serverOptions(options)),
      state_(
          options,
          [this](const rtcore::RenderSettings& settings) {
              FrameMaker::requireMemory(settings, state_.frameSeconds > 0,
                                        rtcore::threadsFor(options_.threads));
              server_.reserveFrame(static_cast<std::uint32_t>(settings.width),
                                   static_cast<std::uint32_t>(settings.height));
          },
          messages_),
      upkeep_(options, state_.document, messages_),
      drawing_(state_, upkeep_,
               {.poll = [this] { return lookDuringFrame(); },
                .publish = [this](const auto& info, const auto& image) { publish(info, image); }},
               options.threads, options.framesPerSecond),
      keptLight_(options, state_.document, drawing_, messages_),
      commands_(state_, messages_,
                {.host = *this, .replies = *this, .publishStatus = [this] { publishStatus(); }}) {}

app::ExitCode ServerLoop::run() {
    setParent(options_.parent);
    upkeep_.load(options_.scene, options_.cachedModel);
    while (!quit_) {
        if (app::stopRequested()) break;
        if (orphaned()) {
            Messages::print(rtcore::form(
                "the process that started this server is gone, and no client is connected: it ends"));
            break;
        }
        turn();
    }
    keptLight_.leave(true);
    return app::stopRequested() ? app::stopExitCode() : app::ExitCode::Done;
}

void ServerLoop::turn() {
    takeLoadedScene();
    upkeep_.advance(drawing_.pace());
    keptLight_.advance(drawing_.idle());
    commands_.finishSideWork();
    commands_.serve(takeCommands());
    if (quit_) return;
    // A command that writes the frame to a file gets the whole frame of what is shown.
    const bool changed = drawing_.takeChange();
    const bool there = state_.wantsExact ? frames().exact() : frames().complete();
    const bool holdsStill = commands_.waits() && !changed && !frames().stale(state_.document) && !there;
    if (!holdsStill) move();
    drawing_.noticePause(commands_.waits());
    const bool due = drawing_.wantsFrame(commands_.waits()) && Clock::now() >= drawing_.due();
    const bool published = due && draw();
    if (published || !drawing_.wantsFrame(commands_.waits())) record();
    tidyUp();
    commands_.answerRequests(drawing_.idle());
    publishStatus();
    if (drawing_.idle()) drawing_.prepareToMove();
    sleep();
}

void ServerLoop::takeLoadedScene() {
    const std::optional<SceneUpkeep::Loaded> loaded = upkeep_.takeLoaded();
    if (!loaded) return;
    if (!loaded->failure) {
        keptLight_.sceneShown();
        moved_ = Clock::now(); // loading was no time to move in
        untidy_ = true;
    }
    commands_.loaded(loaded->failure);
}

// A scene before, or what was needed to read this one, may have been much larger.
void ServerLoop::tidyUp() {
    if (!untidy_ || !drawing_.idle() || upkeep_.works()) return;
    untidy_ = false;
    rtcore::returnFreedMemory();
}

// --- Around it ---

void ServerLoop::setParent(std::optional<std::int64_t> process) {
    parent_.reset();
    if (process) parent_.emplace(*process);
}

bool ServerLoop::orphaned() {
    if (!parent_ || !parent_->ended()) return false;
    // So that a client that came before the parent's end is counted.
    commands_.add(takeCommands());
    return server_.clients() == 0;
}

// In the guard's thread.
Arrivals ServerLoop::lookDuringFrame() {
    std::vector<ipc::Command> commands = takeCommands();
    const bool mayKeep = !commands.empty();
    Arrivals arrivals = commands_.addDuringFrame(std::move(commands));
    arrivals.change = keys_.add(server_.keys()) || arrivals.change;
    arrivals.end = arrivals.end || app::stopRequested() || orphaned();
    tellDuringFrame(mayKeep ? revision_.of(state_, false) : status_.stateRevision);
    return arrivals;
}

// The rest of the status is of the last turn.
void ServerLoop::tellDuringFrame(std::uint64_t stateRevision) {
    const double now = drawing_.wholeSeconds();
    if (now - status_.wholeSeconds < kTold && stateRevision == status_.stateRevision) return;
    status_.wholeSeconds = now;
    status_.stateRevision = stateRevision;
    server_.setStatus(status_);
}

// --- What moves ---

void ServerLoop::move() {
    keys_.add(server_.keys());
    const Clock::time_point now = Clock::now();
    const Clock::duration passed = now - std::exchange(moved_, now);
    // While the image is paused, keys do not move the camera.
    if (!state_.document.ready() || state_.paused) return;
    try {
        state_.walk.move(passed, keys_.take(),
                         [this](const rtcore::ActionTap& tap) { editByKey(tap, state_, *this, messages_); });
    } catch (const rtcore::FileError& error) {
        state_.walk.stopPlaying();
        messages_.complain(rtcore::say("playing ended: {0}", rtcore::sentenceOf(error)));
    }
}

// The exposure of what was recorded is known once there is a frame of it.
void ServerLoop::record() {
    if (!state_.walk.recording()) return;
    try {
        state_.walk.settleRecording(frames().exposure());
    } catch (const rtcore::FileError& error) {
        messages_.complain(rtcore::say("recording ended: {0}", rtcore::sentenceOf(error)));
    }
}

void ServerLoop::refuse(const ipc::Command& command, int code, const rtcore::Sentence& why) {
    server_.refuse(command, code, rtcore::printable(why.english()), rtcore::sentenceJson(why));
}

// --- Frames ---

// False: none was published.
bool ServerLoop::draw() {
    const FrameDrawing::Drawn drawn = drawing_.draw(commands_.waits());
    if (drawn.outcome == FrameDrawing::Outcome::Obstructed) commands_.refuseObstructing(drawn.why);
    if (drawn.outcome == FrameDrawing::Outcome::NoMemory) {
        messages_.complain(drawn.why);
        commands_.refuseWaiting(drawn.why);
    }
    return drawn.outcome == FrameDrawing::Outcome::Published;
}

void ServerLoop::publish(const ipc::FrameInfo& info, const rtcore::LdrImage& image) {
    server_.publishFrame(info, std::as_bytes(std::span(image.pixels)));
    if (!onReady_) return;
    publishStatus();
    const rtcore::RenderSettings& view = state_.document.settings(); // the first frame may be a coarse one
    Messages::print(rtcore::say("ready: instance '{0}', {1}, {2} x {3}", options_.instance,
                                state_.document.title(), view.width, view.height));
    std::exchange(onReady_, nullptr)();
}

void ServerLoop::publishStatus() {
    status_ = statusOf(state_, frames(),
                       {.progress = upkeep_.progress(),
                        .framesPerSecond = drawing_.framesPerSecond(),
                        .wholeSeconds = drawing_.wholeSeconds(),
                        .stateRevision = revision_.of(state_, drawing_.idle()),
                        .imageRevision = imageRevision_.of(state_.document),
                        .messages = messages_.count(),
                        .idle = drawing_.idle()});
    server_.setStatus(status_);
}

void ServerLoop::sleep() {
    const Clock::time_point now = Clock::now();
    const bool ready = state_.document.ready() && !state_.paused;
    const bool draws = drawing_.wantsFrame(commands_.waits());
    if (drawing_.changeWaits() || commands_.hasNew() || (draws && drawing_.due() <= now)) return;
    if (commands_.waits() && state_.document.ready() && !draws) return; // their frame is there
    Clock::duration time = upkeep_.works() || commands_.worksApart() ? kSleepAtWork : kSleep;
    if (ready && !state_.walk.atRest() && !frames().stale(state_.document))
        time = std::min(time, kMotionStep);
    if (commands_.worksBeside()) time = std::min(time, kSideWorkStep);
    if (draws) time = std::min(time, drawing_.due() - now);
    if (ready)
        time = std::min<Clock::duration>(time, std::max<Clock::duration>(state_.walk.untilEvent(), 0ns));
    server_.wait(time);
}

} // namespace rtserver
