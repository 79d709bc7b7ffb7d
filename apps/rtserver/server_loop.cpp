#include "rtserver/server_loop.h"

#include "common/stop.h"

#include "rtcore/platform/error.h"
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

constexpr Clock::duration kSleep = 200ms; ///< less than a turn of Session::move() may last
constexpr Clock::duration kSleepWhileLoading = 20ms;
constexpr auto kMotionStep = 2ms;      ///< until who is not at rest has moved
constexpr auto kAdaptationStep = 16ms; ///< between frames that differ by their exposure alone
constexpr int kMostPending = 64;       ///< of a client; then its further commands stay in its queue
constexpr auto kLongFrame = 1s;        ///< such a frame is given up for a change, but never two in a row

ipc::ServerOptions serverOptions(const Options& options) {
    ipc::ServerOptions result;
    result.instance = options.instance;
    return result;
}

template <typename Vector>
void copy(const Vector& from, float (&to)[3]) {
    for (int i = 0; i < 3; ++i) to[i] = from[i];
}

std::string shortNumber(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

} // namespace

ServerLoop::ServerLoop(const Options& options, std::function<void()> onReady)
    : options_(options), onReady_(std::move(onReady)), server_(serverOptions(options)),
      session_(options,
               [this](const rtcore::RenderSettings& settings) {
                   FrameMaker::requireMemory(settings);
                   server_.reserveFrame(static_cast<std::uint32_t>(settings.width),
                                        static_cast<std::uint32_t>(settings.height));
               }),
      frames_(options.threads), guard_([this] { return guardFrame(); }) {}

ServerLoop::~ServerLoop() = default;

void ServerLoop::setParent(std::optional<std::int64_t> process) {
    parent_.reset();
    if (process) parent_.emplace(*process);
}

bool ServerLoop::forsaken() {
    if (!parent_ || !parent_->ended()) return false;
    // So that who came before the parent's end is counted.
    for (ipc::Command& command : takeCommands()) {
        pending_.push_back(std::move(command));
        changeWaits_ = true;
    }
    return server_.clients() == 0;
}

app::ExitCode ServerLoop::run() {
    setParent(options_.parent);
    load_ = std::make_unique<SceneLoad>(options_.scene, options_.built, options_.import, options_.threads);
    while (!quit_) {
        if (app::stopRequested()) return app::stopExitCode();
        if (forsaken()) {
            Messages::print("who started this server is gone, and no client is connected: it ends");
            break;
        }
        takeLoadedScene();
        takeRefinedTree();
        serve();
        if (quit_) break;
        move();
        shown_ = false;
        if (wantsFrame() && Clock::now() >= due_) draw();
        if (shown_ || !wantsFrame()) record();
        answerWhoWaitsForKeys();
        answerWhoWaitsForIdle();
        tellStatus();
        sleep();
    }
    return app::ExitCode::Done;
}

// --- Scenes ---

void ServerLoop::load(const std::filesystem::path& path, std::optional<std::filesystem::path> built) {
    if (load_ != nullptr) throw std::runtime_error("another scene is being loaded");
    load_ = std::make_unique<SceneLoad>(path, std::move(built), options_.import, options_.threads);
}

void ServerLoop::takeLoadedScene() {
    if (load_ == nullptr || !load_->done()) return;
    const std::unique_ptr<SceneLoad> load = std::move(load_);
    const std::optional<ipc::Command> loader = std::exchange(loader_, std::nullopt);
    try {
        refinement_.reset();
        session_.show(load->take());
        frames_.forget();
        moved_ = Clock::now();
        if (!session_.world().loaded.sceneFile) {
            Messages::print("one unit of " + session_.title() + " is taken for " +
                            shortNumber(session_.metresPerUnit()) +
                            " m; a .scn file with 'metresPerUnit' says it");
        }
        for (const std::string& warning : session_.world().loaded.warnings)
            Messages::print("warning: " + warning);
    } catch (const std::exception& error) {
        if (!session_.ready()) throw;
        messages_.complain(error.what());
        if (loader) server_.answer(*loader, ipc::AnswerStatus::Failed, failureText(error));
        return;
    }
    if (!loader) return;
    tellStatus();
    server_.answer(*loader, ipc::AnswerStatus::Done);
}

// The frames are the same with either tree; they only come faster.
void ServerLoop::takeRefinedTree() {
    if (!session_.ready()) return;
    if (refinement_ == nullptr) {
        // After the first frame, which nothing should slow down.
        if (!session_.world().loaded.fastTree || session_.stale()) return;
        refinement_ = std::make_unique<TreeRefinement>(session_.world(), options_.threads);
    }
    if (!refinement_->done()) return;
    const std::unique_ptr<TreeRefinement> refinement = std::move(refinement_);
    TreeRefinement::Result result = refinement->take();
    session_.useTree(std::move(result.tree), std::move(result.tracer));
    Messages::print("the exact kd-tree is in use; it took " + shortNumber(result.seconds) + " s");
}

// --- Commands ---

std::vector<ipc::Command> ServerLoop::takeCommands() {
    std::array<int, ipc::kMaxClients> counts{};
    ipc::ClientSet full;
    for (const ipc::Command& command : pending_) {
        const auto slot = static_cast<std::size_t>(command.slot);
        if (++counts[slot] >= kMostPending) full.set(slot);
    }
    return server_.takeCommands(full);
}

// Of each client in order; nobody waits for the commands of another.
void ServerLoop::serve() {
    for (ipc::Command& command : takeCommands()) pending_.push_back(std::move(command));
    ipc::ClientSet waiting;
    std::deque<ipc::Command> again;
    for (ipc::Command& command : pending_) {
        if (quit_) return;
        const auto slot = static_cast<std::size_t>(command.slot);
        if (!waiting[slot] && serveOne(command)) continue;
        waiting.set(slot);
        again.push_back(std::move(command));
    }
    pending_ = std::move(again);
    waiting_ = pending_.size();
}

// False: to be run again.
bool ServerLoop::serveOne(const ipc::Command& command) {
    try {
        const Result result = runCommand(command.text, session_, *this);
        switch (result.turn) {
        case Turn::Again:
            return false;
        case Turn::WhenIdle:
            if (command.wantsAnswer) idleWaiters_.push_back(command);
            return true;
        case Turn::WhenLoaded:
            loader_ = command;
            return true;
        case Turn::WhenReleased:
            if (command.wantsAnswer) keyWaiters_.push_back({command, result.press});
            return true;
        case Turn::Done:
            break;
        }
        tellStatus(); // before the answer, so that who has it sees no idle flag of the time before
        server_.answer(command, ipc::AnswerStatus::Done, result.answer);
    } catch (const std::exception& error) {
        server_.answer(command, ipc::AnswerStatus::Failed, failureText(error));
        if (!command.wantsAnswer) messages_.complain(rtcore::quoted(command.text) + ": " + error.what());
    }
    return true;
}

void ServerLoop::answerWhoWaitsForIdle() {
    if (session_.paused || !session_.idles) {
        const std::string reason = session_.paused ? "1 the server was paused" : "1 idling was turned off";
        for (const ipc::Command& command : idleWaiters_)
            server_.answer(command, ipc::AnswerStatus::Failed, reason);
        idleWaiters_.clear();
    }
    if (!idle() || idleWaiters_.empty()) return;
    tellStatus();
    for (const ipc::Command& command : idleWaiters_) server_.answer(command, ipc::AnswerStatus::Done);
    idleWaiters_.clear();
}

void ServerLoop::answerWhoWaitsForKeys() {
    if (keyWaiters_.empty()) return;
    tellStatus();
    std::erase_if(keyWaiters_, [this](const KeyWaiter& waiter) {
        // Who was stopped, or killed, holds no key down any more.
        if (!server_.isConnected(waiter.command)) {
            session_.keyboard().endPress(waiter.press);
            return true;
        }
        if (session_.keyboard().isDown(waiter.press)) return false;
        server_.answer(waiter.command, ipc::AnswerStatus::Done);
        return true;
    });
}

// --- Frames ---

void ServerLoop::move() {
    const ipc::KeyState keys = server_.keys();
    const Clock::time_point now = Clock::now();
    const Clock::duration passed = now - std::exchange(moved_, now);
    // Who looks at a picture that stands still does not move about.
    if (!session_.ready() || session_.paused) return;
    try {
        session_.move(passed, keys);
    } catch (const rtcore::FileError& error) {
        session_.stopPlaying();
        messages_.complain(std::string("playing ended: ") + error.what());
    }
}

// The exposure of what was recorded is known once there is a frame of it.
void ServerLoop::record() {
    if (!session_.recording()) return;
    try {
        session_.settleRecording(frames_.exposure());
    } catch (const rtcore::FileError& error) {
        messages_.complain(std::string("recording ended: ") + error.what());
    }
}

bool ServerLoop::wantsFrame() const {
    const bool rough = frames_.reduced() && scale() == 1;
    return session_.ready() && !session_.paused &&
           (session_.stale() || rough || !frames_.settled() || !session_.idles);
}

// Full resolution for what stays, and for who wants the frame for a file.
double ServerLoop::scale() const {
    const bool moves = session_.frameSeconds > 0 && !session_.atRest() && pending_.empty();
    return moves ? governor_.scale() : 1;
}

bool ServerLoop::idle() const {
    return session_.ready() && session_.idles && !session_.stale() && frames_.settled() &&
           !frames_.reduced() && session_.atRest() && load_ == nullptr;
}

void ServerLoop::draw() {
    try {
        drawFrame();
    } catch (const std::bad_alloc&) {
        // Without a frame to go back to there is nothing to serve.
        if (publishedFrames_ == 0 || std::exchange(wentBack_, true)) throw;
        goBack();
    }
}

// Who waits for the frame that there is no memory for is told so.
void ServerLoop::goBack() {
    const auto size = [](const rtcore::RenderSettings& settings) {
        return std::to_string(settings.width) + " x " + std::to_string(settings.height);
    };
    const std::string text = "not enough memory for frames of " + size(session_.settings()) +
                             " at these settings; " + "back to those of the last frame, " + size(drawn_);
    frames_.drop();
    session_.setSettings(drawn_);
    messages_.complain(text);
    const std::string answer = std::to_string(static_cast<int>(app::ExitCode::TryAgain)) + " " + text;
    for (const ipc::Command& command : idleWaiters_)
        server_.answer(command, ipc::AnswerStatus::Failed, answer);
    idleWaiters_.clear();
    ipc::ClientSet told;
    const auto end = pending_.begin() + static_cast<std::ptrdiff_t>(std::exchange(waiting_, 0));
    pending_.erase(std::remove_if(pending_.begin(), end,
                                  [&](const ipc::Command& command) {
                                      const auto slot = static_cast<std::size_t>(command.slot);
                                      if (told[slot]) return false;
                                      told.set(slot);
                                      server_.answer(command, ipc::AnswerStatus::Failed, answer);
                                      return true;
                                  }),
                   end);
}

void ServerLoop::drawFrame() {
    const double scale = this->scale();
    if (session_.stale() || !session_.idles || frames_.scale() < scale) {
        begun_ = Clock::now();
        changeWaits_ = false;
        rtcore::RenderControl control;
        bool whole = false;
        {
            const FrameGuard::Watch watch(guard_, control.cancel);
            whole = frames_.trace(session_, scale, control);
        }
        if (guardError_) std::rethrow_exception(std::exchange(guardError_, nullptr));
        gaveUpLast_ = !whole;
        if (!whole) return;
        if (session_.frameSeconds > 0) governor_.learn(frames_.seconds(), scale, session_.frameSeconds);
        session_.drawn();
    }
    frames_.develop(session_);
    publish();
}

void ServerLoop::publish() {
    const rtcore::LdrImage& image = frames_.image();
    ipc::FrameInfo info;
    info.width = static_cast<std::uint32_t>(image.width);
    info.height = static_cast<std::uint32_t>(image.height);
    const auto side = static_cast<std::uint32_t>(session_.settings().antialiasing);
    info.samples = side * side;
    server_.publishFrame(info, std::as_bytes(std::span(image.pixels)));

    shown_ = true;
    drawn_ = session_.settings();
    wentBack_ = false;
    const Clock::time_point now = Clock::now();
    count(now);
    due_ = now;
    if (!session_.stale() && !frames_.settled()) due_ = now + kAdaptationStep;
    if (options_.framesPerSecond > 0) {
        const std::chrono::duration<double> interval(1 / options_.framesPerSecond);
        due_ = std::max(due_, now + std::chrono::duration_cast<Clock::duration>(interval));
    }
    if (publishedFrames_++ > 0) return;
    tellStatus();
    Messages::print("ready: instance '" + options_.instance + "', " + session_.title() + ", " +
                    std::to_string(info.width) + " x " + std::to_string(info.height));
    onReady_();
}

void ServerLoop::sleep() {
    const Clock::time_point now = Clock::now();
    const bool tooEarly = session_.stale() && due_ > now; // for the frame that commands wait for
    if (!pending_.empty() && session_.ready() && !tooEarly) return;
    if (session_.ready() && !session_.paused && !session_.atRest()) {
        server_.wait(std::max<Clock::duration>(due_ - now, session_.stale() ? 0ms : kMotionStep));
    } else if (wantsFrame()) {
        if (due_ > now) server_.wait(due_ - now);
    } else {
        const bool busy = load_ != nullptr || refinement_ != nullptr;
        Clock::duration time = busy ? kSleepWhileLoading : kSleep;
        if (session_.ready() && !session_.paused)
            time = std::min<Clock::duration>(time, std::max<Clock::duration>(session_.untilEvent(), 0ns));
        server_.wait(time);
    }
}

// --- Long frames, in the guard's thread ---

bool ServerLoop::guardFrame() {
    if (guardError_) return true;
    try {
        return pollDuringFrame();
    } catch (...) {
        guardError_ = std::current_exception();
        return true;
    }
}

bool ServerLoop::pollDuringFrame() {
    bool leave = app::stopRequested();
    const auto hasMore = [this](const ipc::Command& of) {
        return std::any_of(pending_.begin(), pending_.end(),
                           [&](const ipc::Command& command) { return command.slot == of.slot; });
    };
    for (ipc::Command& command : takeCommands()) {
        if (command.text == "ping" && !hasMore(command)) {
            server_.answer(command, ipc::AnswerStatus::Done, "pong");
            continue;
        }
        leave = leave || command.text == "quit" || command.text == "exit";
        changeWaits_ = true;
        pending_.push_back(std::move(command));
    }
    return leave || forsaken() || (changeWaits_ && !gaveUpLast_ && Clock::now() - begun_ > kLongFrame);
}

// --- Status ---

void ServerLoop::count(Clock::time_point now) {
    published_.push_back(now);
    while (now - published_.front() > 1s) published_.pop_front();
}

void ServerLoop::tellStatus() {
    ipc::Status status;
    status.progress = load_ != nullptr ? load_->fraction() : 1;
    status.paused = session_.paused ? 1 : 0;
    status.recording = session_.recording() ? 1 : 0;
    const Clock::time_point now = Clock::now();
    status.framesPerSecond = static_cast<double>(std::count_if(
        published_.begin(), published_.end(), [&](Clock::time_point then) { return now - then <= 1s; }));
    if (session_.ready()) {
        const rtcore::Camera& camera = session_.camera();
        status.frameSeconds = frames_.seconds();
        status.raysPerSecond =
            frames_.seconds() > 0 ? static_cast<double>(frames_.rays()) / frames_.seconds() : 0;
        status.polygons = session_.world().loaded.scene.mesh().triangles.size();
        status.width = static_cast<std::uint32_t>(session_.settings().width);
        status.height = static_cast<std::uint32_t>(session_.settings().height);
        copy(camera.eye, status.eye);
        copy(normalize(camera.forward), status.forward);
        copy(normalize(camera.up), status.up);
        status.fieldOfView = camera.horizontalFov;
        status.mode = session_.walking() ? 1 : 0;
        status.exposure = frames_.exposure();
        status.idle = idle() ? 1 : 0;
    }
    server_.setStatus(status);
}

} // namespace rtserver
