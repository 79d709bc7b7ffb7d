#include "rtserver/server_loop.h"

#include "common/run_program.h"
#include "common/stop.h"

#include "rtcore/platform/error.h"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <utility>

namespace rtserver {

namespace {

using namespace std::chrono_literals;

constexpr auto kSleep = 250ms;
constexpr auto kSleepWhileLoading = 20ms;
constexpr auto kMotionStep = 2ms;      ///< until who is not at rest has moved
constexpr auto kAdaptationStep = 16ms; ///< between frames that differ by their exposure alone
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

void print(const std::string& text) { app::printMessage(serverSpec().name, text); }

} // namespace

ServerLoop::ServerLoop(const Options& options, std::function<void()> onReady)
    : options_(options), onReady_(std::move(onReady)), server_(serverOptions(options)),
      session_(options,
               [this](int width, int height) {
                   server_.beginFrame(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height));
               }),
      frames_(options.threads), guard_([this] { return guardFrame(); }) {}

ServerLoop::~ServerLoop() = default;

app::ExitCode ServerLoop::run() {
    load_ = std::make_unique<SceneLoad>(options_.scene, options_.import, options_.threads);
    while (!quit_) {
        if (app::stopRequested()) return app::stopExitCode();
        takeLoadedScene();
        serve();
        if (quit_) break;
        move();
        if (wantsFrame() && Clock::now() >= due_) draw();
        answerWhoWaitsForIdle();
        tellStatus();
        sleep();
    }
    return app::ExitCode::Done;
}

// --- Scenes ---

void ServerLoop::load(const std::filesystem::path& path) {
    if (load_ != nullptr) throw std::runtime_error("another scene is being loaded");
    load_ = std::make_unique<SceneLoad>(path, options_.import, options_.threads);
}

void ServerLoop::takeLoadedScene() {
    if (load_ == nullptr || !load_->done()) return;
    const std::unique_ptr<SceneLoad> load = std::move(load_);
    const std::optional<ipc::Command> loader = std::exchange(loader_, std::nullopt);
    try {
        session_.show(load->take());
        frames_.forget();
        moved_ = Clock::now();
        for (const std::string& warning : session_.world().loaded.warnings) print("warning: " + warning);
    } catch (const std::exception& error) {
        if (!session_.ready()) throw;
        print(error.what());
        if (loader) server_.answer(*loader, ipc::AnswerStatus::Failed, failureText(error));
        return;
    }
    if (!loader) return;
    tellStatus();
    server_.answer(*loader, ipc::AnswerStatus::Done);
}

// --- Commands ---

void ServerLoop::serve() {
    for (ipc::Command& command : server_.takeCommands()) pending_.push_back(std::move(command));
    while (!pending_.empty() && !quit_) {
        if (!serveOne(pending_.front())) break;
        pending_.pop_front();
    }
}

// False: to be run again.
bool ServerLoop::serveOne(const ipc::Command& command) {
    try {
        const Result result = runCommand(command.text, session_, *this);
        switch (result.turn) {
        case Turn::Again:
            return false;
        case Turn::WhenIdle:
            idleWaiters_.push_back(command);
            return true;
        case Turn::WhenLoaded:
            loader_ = command;
            return true;
        case Turn::Done:
            break;
        }
        tellStatus(); // before the answer, so that who has it sees no idle flag of the time before
        server_.answer(command, ipc::AnswerStatus::Done, result.answer);
    } catch (const std::exception& error) {
        server_.answer(command, ipc::AnswerStatus::Failed, failureText(error));
        if (!command.wantsAnswer) print(command.text + ": " + error.what());
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

// --- Frames ---

void ServerLoop::move() {
    ipc::KeyState keys = server_.keys();
    const Clock::time_point now = Clock::now();
    const Clock::duration passed = now - std::exchange(moved_, now);
    // Who looks at a picture that stands still does not move about.
    if (!session_.ready() || session_.paused) return;
    session_.keyboard().collect(keys);
    session_.move(passed, keys);
}

bool ServerLoop::wantsFrame() const {
    return session_.ready() && !session_.paused &&
           (session_.stale() || !frames_.settled() || !session_.idles);
}

bool ServerLoop::idle() const {
    return session_.ready() && session_.idles && !session_.stale() && frames_.settled() && session_.atRest() &&
           load_ == nullptr;
}

void ServerLoop::draw() {
    if (session_.stale() || !session_.idles) {
        begun_ = Clock::now();
        changeWaits_ = false;
        rtcore::RenderControl control;
        bool whole = false;
        {
            const FrameGuard::Watch watch(guard_, control.cancel);
            whole = frames_.trace(session_, control);
        }
        if (guardError_) std::rethrow_exception(std::exchange(guardError_, nullptr));
        gaveUpLast_ = !whole;
        if (!whole) return;
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
    print("ready: instance '" + options_.instance + "', " + session_.title() + ", " +
          std::to_string(info.width) + " x " + std::to_string(info.height));
    onReady_();
}

void ServerLoop::sleep() {
    if (!pending_.empty() && session_.ready()) return;
    const Clock::time_point now = Clock::now();
    if (session_.ready() && !session_.paused && !session_.atRest()) {
        server_.wait(std::max<Clock::duration>(due_ - now, session_.stale() ? 0ms : kMotionStep));
    } else if (wantsFrame()) {
        if (due_ > now) server_.wait(due_ - now);
    } else {
        server_.wait(load_ != nullptr ? Clock::duration(kSleepWhileLoading) : Clock::duration(kSleep));
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
    for (ipc::Command& command : server_.takeCommands()) {
        if (command.text == "ping" && pending_.empty()) {
            server_.answer(command, ipc::AnswerStatus::Done, "pong");
            continue;
        }
        leave = leave || command.text == "quit" || command.text == "exit";
        changeWaits_ = true;
        pending_.push_back(std::move(command));
    }
    return leave || (changeWaits_ && !gaveUpLast_ && Clock::now() - begun_ > kLongFrame);
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
