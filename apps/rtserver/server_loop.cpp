#include "rtserver/server_loop.h"

#include "common/frames/frame_status.h"
#include "common/process/stop.h"

#include "rtcore/platform/error.h"
#include "rtcore/platform/file_waits.h"
#include "rtcore/settings/nearest_name.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <new>
#include <span>
#include <stdexcept>
#include <utility>

namespace rtserver {

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr Clock::duration kSleep = 200ms; ///< less than a step of ServerState::move() may last
constexpr Clock::duration kSleepWhileLoading = 20ms;
constexpr auto kMotionStep = 2ms;        ///< until a moving camera has moved
constexpr auto kSideWorkStep = 2ms;      ///< until a file that is written is asked for again
constexpr auto kObstruction = 10s;       ///< for a frame that a client waits for that has sent more commands
constexpr auto kMemoryPause = 1s;        ///< between frames for which there is no memory
constexpr auto kPatience = 1s;           ///< for files that are being written when the server ends
constexpr std::size_t kMostPending = 64; ///< of a client; then its further commands stay in its queue

ipc::ServerOptions serverOptions(const Options& options) {
    ipc::ServerOptions result;
    result.instance = options.instance;
    return result;
}

bool isEnd(const ipc::Command& command) { return command.text == "quit" || command.text == "exit"; }

std::string shortNumber(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

} // namespace

ServerLoop::ServerLoop(const Options& options, std::function<void()> onReady)
    : options_(options), onReady_(std::move(onReady)), server_(serverOptions(options)),
      state_(
          options,
          [this](const rtcore::RenderSettings& settings) {
              FrameMaker::requireMemory(settings);
              server_.reserveFrame(static_cast<std::uint32_t>(settings.width),
                                   static_cast<std::uint32_t>(settings.height));
          },
          messages_),
      frames_(options.threads), pacer_(options.framesPerSecond), guard_([this] { return guardFrame(); }) {}

ServerLoop::~ServerLoop() { sideWork_.waitFor(kPatience); }

void ServerLoop::setParent(std::optional<std::int64_t> process) {
    parent_.reset();
    if (process) parent_.emplace(*process);
}

bool ServerLoop::orphaned() {
    if (!parent_ || !parent_->ended()) return false;
    // So that a client that came before the parent's end is counted.
    for (ipc::Command& command : takeCommands()) commands_.add(std::move(command));
    return server_.clients() == 0;
}

app::ExitCode ServerLoop::run() {
    setParent(options_.parent);
    load_ =
        std::make_unique<SceneLoad>(options_.scene, options_.cachedModel, options_.import, options_.threads);
    while (!quit_) {
        if (app::stopRequested()) return app::stopExitCode();
        if (orphaned()) {
            Messages::print(
                "the process that started this server is gone, and no client is connected: it ends");
            break;
        }
        takeLoadedScene();
        takeRefinedTree();
        takeShadowMaps();
        finishSideWork();
        serve();
        if (quit_) break;
        // A command that writes the frame to a file gets the whole frame of what is shown.
        const bool holdsStill = commands_.waits() && !changeWaits_ && !state_.stale() && !frames_.whole();
        changeWaits_ = false;
        if (!holdsStill) move();
        shown_ = false;
        keepsPicture_ = state_.paused && (keepsPicture_ || !wantsFrame());
        if (wantsFrame() && Clock::now() >= pacer_.due()) draw();
        if (shown_ || !wantsFrame()) record();
        answerRequests();
        publishStatus();
        sleep();
    }
    return app::ExitCode::Done;
}

// --- Scenes ---

void ServerLoop::load(const std::filesystem::path& path, std::optional<std::filesystem::path> cachedModel) {
    if (load_ != nullptr) throw std::runtime_error("another scene is being loaded");
    load_ = std::make_unique<SceneLoad>(path, std::move(cachedModel), options_.import, options_.threads);
}

void ServerLoop::takeLoadedScene() {
    if (load_ == nullptr || !load_->done()) return;
    const std::unique_ptr<SceneLoad> load = std::move(load_);
    try {
        refinement_.reset();
        mapping_.reset();
        mapless_ = false;
        state_.show(load->take());
        messages_.forget();
        frames_.forget();
        schedule_.forget();
        rtcore::allowRegularFilesOnly(); // from here on paths come from clients
        moved_ = Clock::now();
        if (!state_.world().loaded.sceneFile) {
            Messages::print("one unit of " + state_.title() + " is taken for " +
                            shortNumber(state_.metresPerUnit()) +
                            " m; a .scn file with 'metresPerUnit' says it");
        }
        for (const std::string& warning : state_.world().loaded.warnings) messages_.warn(warning);
    } catch (const std::exception& error) {
        if (!state_.ready()) throw;
        messages_.complain(error.what());
        const Failure failure = failureOf(error);
        requests_.loadFailed(failure.code, failure.text);
        return;
    }
    if (requests_.waitsForLoad()) publishStatus();
    requests_.loaded();
}

// The frames are the same with either tree; they only come faster.
void ServerLoop::takeRefinedTree() {
    if (!state_.ready()) return;
    if (refinement_ == nullptr) {
        // After the first frame, which nothing should slow down.
        if (!state_.world().loaded.fastTree || state_.stale() || !frames_.whole()) return;
        refinement_ = std::make_unique<TreeRefinement>(state_.world(), options_.threads);
    }
    if (!refinement_->done()) return;
    const std::unique_ptr<TreeRefinement> refinement = std::move(refinement_);
    TreeRefinement::Result result = refinement->take();
    state_.useTree(std::move(result.tree), std::move(result.tracer));
    Messages::print("the exact kd-tree is in use; it took " + shortNumber(result.seconds) + " s");
}

// Where whole frames are not quick enough to be seen at once: while nothing else is to do; or soon, where not
// even the coarsest are.
void ServerLoop::takeShadowMaps() {
    if (!state_.ready() || state_.world().shadowMaps != nullptr) return;
    if (mapping_ == nullptr) {
        const double quick = state_.frameSeconds;
        const bool needed =
            quick > 0 && (schedule_.coarsest() > quick || (idle() && frames_.seconds() > quick));
        if (mapless_ || !needed || state_.world().loaded.fastTree) return;
        mapping_ = std::make_unique<ShadowMapping>(state_.world());
    }
    if (!mapping_->done()) return;
    try {
        state_.useShadowMaps(std::exchange(mapping_, nullptr)->take());
    } catch (const std::bad_alloc&) { // then without
    }
    mapless_ = state_.world().shadowMaps == nullptr;
}

// --- Commands ---

std::vector<ipc::Command> ServerLoop::takeCommands() {
    ipc::ClientSet full;
    for (const ipc::Command* command : commands_.ofClientsWith(kMostPending)) {
        if (server_.isConnected(*command)) full.set(static_cast<std::size_t>(command->slot));
    }
    return server_.takeCommands(full);
}

void ServerLoop::serve() {
    for (ipc::Command& command : takeCommands()) {
        // Not to be held up by a file that does not answer.
        if (isEnd(command) && commands_.isBeside(command.client)) quit_ = true;
        commands_.add(std::move(command));
    }
    commands_.serve(
        [this](const ipc::Command& command) { return quit_ ? Served::Again : serveOne(command); });
}

Served ServerLoop::serveOne(const ipc::Command& command) {
    Served served = Served::Done;
    answerBy(command, [&] {
        Result result = runCommand(command.text, state_, *this);
        switch (result.when) {
        case ReplyWhen::Again:
            served = Served::Again;
            break;
        case ReplyWhen::Beside:
            sideWork_.start(command, std::move(result.work));
            served = Served::Beside;
            break;
        case ReplyWhen::WhenIdle:
            requests_.addForIdle(command);
            break;
        case ReplyWhen::WhenLoaded:
            requests_.addForLoad(command);
            break;
        case ReplyWhen::WhenReleased:
            requests_.addForKey(command, result.press);
            break;
        case ReplyWhen::Done:
            return std::optional(std::move(result.answer));
        }
        return std::optional<std::string>();
    });
    return served;
}

// Nothing: the answer comes later.
void ServerLoop::answerBy(const ipc::Command& command,
                          const std::function<std::optional<std::string>()>& act) {
    try {
        const std::optional<std::string> text = act();
        if (!text) return;
        publishStatus(); // before the answer, so that its receiver sees no outdated idle flag
        server_.answer(command, *text);
    } catch (const std::exception& error) {
        refuseFor(command, error);
        if (!command.wantsAnswer) messages_.complain(rtcore::quoted(command.text) + ": " + error.what());
    }
}

void ServerLoop::refuseFor(const ipc::Command& command, const std::exception& error) {
    const Failure failure = failureOf(error);
    server_.refuse(command, failure.code, failure.text);
}

void ServerLoop::refuseAll(const std::vector<ipc::Command>& commands, app::ExitCode code,
                           const std::string& text) {
    for (const ipc::Command& command : commands) server_.refuse(command, static_cast<int>(code), text);
}

void ServerLoop::finishSideWork() {
    for (const SideWork::Done& done : sideWork_.takeDone()) {
        answerBy(done.command, [&] { return std::optional(done.finish()); });
        commands_.resume(done.command.client);
    }
}

void ServerLoop::answerRequests() {
    if (requests_.waitForKeys()) {
        publishStatus();
        requests_.answerReleased([this](std::uint64_t press) { return state_.keyboard().isDown(press); },
                                 [this](std::uint64_t press) { state_.keyboard().endPress(press); });
    }
    if (state_.paused || !state_.idles) {
        requests_.refuseIdle(app::ExitCode::Failed,
                             state_.paused ? "the server was paused" : "idling was turned off");
    }
    if (!idle() || !requests_.waitForIdle()) return;
    publishStatus();
    requests_.idle();
}

// --- Frames ---

void ServerLoop::move() {
    keys_.add(server_.keys());
    const Clock::time_point now = Clock::now();
    const Clock::duration passed = now - std::exchange(moved_, now);
    // While the image is paused, keys do not move the camera.
    if (!state_.ready() || state_.paused) return;
    try {
        state_.move(passed, keys_.take());
    } catch (const rtcore::FileError& error) {
        state_.stopPlaying();
        messages_.complain(std::string("playing ended: ") + error.what());
    }
}

// The exposure of what was recorded is known once there is a frame of it.
void ServerLoop::record() {
    if (!state_.recording()) return;
    try {
        state_.settleRecording(frames_.exposure());
    } catch (const rtcore::FileError& error) {
        messages_.complain(std::string("recording ended: ") + error.what());
    }
}

bool ServerLoop::wantsFrame() const {
    if (!state_.ready() || keepsPicture_) return false;
    if (state_.stale() || wantsWholeFrame()) return true;
    return !state_.paused && (!frames_.settled() || !state_.idles);
}

bool ServerLoop::standsStill() const { return state_.paused || state_.atRest(); }

// All pixels for an unchanged view, and for commands that write the frame to a file.
bool ServerLoop::wantsWholeFrame() const { return !frames_.whole() && (standsStill() || commands_.waits()); }

bool ServerLoop::idle() const {
    return state_.ready() && state_.idles && !state_.stale() && frames_.settled() && frames_.whole() &&
           state_.atRest() && load_ == nullptr;
}

void ServerLoop::draw() {
    try {
        drawFrame();
    } catch (const std::bad_alloc&) {
        if (wholeFrames_ == 0) throw; // there is nothing to go back to
        goBack();
    }
}

// Commands that wait for a frame are refused when there is no memory for it.
void ServerLoop::goBack() {
    const auto size = [](const rtcore::RenderSettings& settings) {
        return std::to_string(settings.width) + " x " + std::to_string(settings.height);
    };
    const std::string text = "not enough memory for frames of " + size(state_.settings()) +
                             " at these settings; " + "back to those of the last frame, " + size(drawn_);
    frames_.drop();
    state_.goBackTo(drawn_);
    // Even those may need more than there is now. The last frame stands, and memory may come back.
    if (std::exchange(wentBack_, true)) pacer_.pauseUntil(Clock::now() + kMemoryPause);
    messages_.complain(text);
    requests_.refuseIdle(app::ExitCode::TryAgain, text);
    refuseAll(commands_.takeWaiting(), app::ExitCode::TryAgain, text);
}

void ServerLoop::drawFrame() {
    const bool trace = state_.stale() || wantsWholeFrame() || !state_.idles || !frames_.hasRadiance();
    if (trace && !traceFrame()) return;
    frames_.develop(state_);
    publish();
    if (trace) schedule_.shown(Clock::now() - begun_);
}

// False: it was left.
bool ServerLoop::traceFrame() {
    const rtcore::Scene& scene = state_.world().loaded.scene;
    const rtcore::RenderSettings& settings = state_.settings();
    const rtcore::ShadowMaps* const maps = state_.world().shadowMaps.get();
    const bool mapped = maps != nullptr && maps->suit(settings);
    const FrameDetail detail = schedule_.begin(
        {.changed = state_.stale() || (!standsStill() && !commands_.waits()),
         .waitedFor = commands_.waits(),
         .frameSeconds = state_.frameSeconds,
         .work = {workOf(settings, scene), workOf(settingsAt(settings, {1, true}), scene, mapped)}});
    begun_ = Clock::now();
    changeWaits_ = endWaits_ = obstructed_ = false;
    rtcore::RenderControl control;
    bool whole = false;
    {
        const FrameGuard::Watch watch(guard_, control.cancel);
        whole = frames_.trace(state_, detail, control);
    }
    if (guardError_) std::rethrow_exception(std::exchange(guardError_, nullptr));
    if (whole) {
        state_.drawn();
        return true;
    }
    schedule_.left(Clock::now() - begun_);
    if (std::exchange(obstructed_, false)) clearTheWay();
    return false;
}

// A setting with which no frame is ever finished must remain changeable.
void ServerLoop::clearTheWay() {
    refuseAll(commands_.takeObstructing(), app::ExitCode::TryAgain,
              "given up: the frame that it needs takes too long for the commands behind it; send them later");
}

void ServerLoop::publish() {
    const rtcore::LdrImage& image = frames_.image();
    ipc::FrameInfo info;
    info.width = static_cast<std::uint32_t>(image.width);
    info.height = static_cast<std::uint32_t>(image.height);
    const auto side = static_cast<std::uint32_t>(state_.settings().antialiasing);
    info.samples = frames_.whole() ? side * side : 0;
    server_.publishFrame(info, std::as_bytes(std::span(image.pixels)));

    shown_ = true;
    if (frames_.whole()) {
        drawn_ = state_.settings();
        wentBack_ = false;
        ++wholeFrames_;
    }
    pacer_.published(begun_, Clock::now(), !state_.stale() && !frames_.settled());
    if (publishedFrames_++ > 0) return;
    publishStatus();
    Messages::print("ready: instance '" + options_.instance + "', " + state_.title() + ", " +
                    std::to_string(info.width) + " x " + std::to_string(info.height));
    onReady_();
}

void ServerLoop::sleep() {
    const Clock::time_point now = Clock::now();
    const bool ready = state_.ready() && !state_.paused;
    const bool draws = wantsFrame();
    if (changeWaits_ || commands_.hasNew() || (draws && pacer_.due() <= now)) return;
    if (commands_.waits() && state_.ready() && !draws) return; // their frame is there
    const bool works = load_ != nullptr || refinement_ != nullptr || mapping_ != nullptr;
    Clock::duration time = works ? kSleepWhileLoading : kSleep;
    if (ready && !state_.atRest() && !state_.stale()) time = std::min<Clock::duration>(time, kMotionStep);
    if (sideWork_.underWay()) time = std::min<Clock::duration>(time, kSideWorkStep);
    if (draws) time = std::min(time, pacer_.due() - now);
    if (ready) time = std::min<Clock::duration>(time, std::max<Clock::duration>(state_.untilEvent(), 0ns));
    server_.wait(time);
}

// --- Frames that take their time, in the guard's thread ---

bool ServerLoop::guardFrame() {
    if (guardError_) return true;
    try {
        pollDuringFrame();
        obstructed_ = commands_.obstructs() && Clock::now() - begun_ > kObstruction;
        return endWaits_ || obstructed_ || app::stopRequested() || orphaned() ||
               schedule_.leaves(Clock::now() - begun_, changeWaits_);
    } catch (...) {
        guardError_ = std::current_exception();
        return true;
    }
}

// The status stays as it is: it tells of the frame that is drawn, too.
void ServerLoop::tell(const ipc::Command& command) {
    try {
        server_.answer(command, runCommand(command.text, state_, *this).answer);
    } catch (const std::exception& error) {
        refuseFor(command, error);
    }
}

void ServerLoop::pollDuringFrame() {
    for (ipc::Command& command : takeCommands()) {
        const app::CommandEffect effect = effectOf(command.text);
        const bool tells = effect == app::CommandEffect::Tells, waits = effect == app::CommandEffect::Waits;
        if (tells && !commands_.hasMore(command.client)) {
            tell(command);
            continue;
        }
        endWaits_ = endWaits_ || isEnd(command);
        changeWaits_ = changeWaits_ || (!tells && !waits && !commands_.hasMore(command.client));
        commands_.add(std::move(command));
    }
    if (sideWork_.anyDone()) changeWaits_ = true;
    if (keys_.add(server_.keys())) changeWaits_ = true;
}

// --- Status ---

void ServerLoop::publishStatus() {
    ipc::Status status;
    status.progress = load_ != nullptr ? load_->fraction() : 1;
    status.paused = state_.paused ? 1 : 0;
    status.recording = state_.recording() ? 1 : 0;
    status.messages = messages_.count();
    status.framesPerSecond = pacer_.framesPerSecond(Clock::now());
    if (state_.ready()) {
        status.frameSeconds = frames_.seconds();
        status.raysPerSecond =
            frames_.seconds() > 0 ? static_cast<double>(frames_.rays()) / frames_.seconds() : 0;
        status.polygons = state_.world().loaded.scene.mesh().triangles.size();
        app::setView(state_.camera(), state_.settings().width, state_.settings().height, status);
        status.mode = state_.onUnseenFloor() ? 2 : state_.walking() ? 1 : 0;
        status.exposure = frames_.exposure();
        status.idle = idle() ? 1 : 0;
    }
    server_.setStatus(status);
}

} // namespace rtserver
