#include "bridge/paths/resting_view.h"

#include "common/commands/command_lines.h"

#include "rtcore/platform/error.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace bridge {

namespace {

constexpr double kRest = 0.25;      ///< seconds: between two taps of a key nothing is begun
constexpr std::uint64_t kFiles = 4; ///< pairs: a Renderer may still read those of the images before

} // namespace

// Numbers of runs grow also from one bridge to the next that happens to get its process number.
RestingView::RestingView(std::unique_ptr<PathRenderer> renderer, const Clock& clock, Links links)
    : renderer_(std::move(renderer)), clock_(clock), links_(std::move(links)),
      run_(static_cast<std::uint64_t>(clock.nanoseconds() / 1000)) {}

RestingView::Moment RestingView::momentOf(const ipc::Status& status) {
    Moment moment{{}, status.width, status.height, status.imageRevision};
    float* const end = std::copy_n(
        status.up, 3, std::copy_n(status.forward, 3, std::copy_n(status.eye, 3, moment.view.begin())));
    *end = status.fieldOfView > 0 ? status.fieldOfView : status.parallelWidth;
    return moment;
}

void RestingView::statusChanged(const ipc::Status& status) {
    if (!renderer_) return;
    const Moment moment = momentOf(status);
    const bool rests = status.idle != 0 && status.paused == 0 && status.progress >= 1;
    if (!rests || !(moment == moment_)) {
        interrupt();
        again_ = false;
    }
    moment_ = moment;
    rests_ = rests;
}

void RestingView::serverFound() {
    if (renderer_ != nullptr) links_.ask(app::command::restLight(true), [](bool, const std::string&) {});
}

void RestingView::serverGone() {
    interrupt();
    rests_ = false;
}

void RestingView::interrupt() {
    since_ = clock_.seconds();
    if (!std::exchange(begun_, false)) return;
    if (std::exchange(working_, false)) renderer_->giveUp();
    ++run_;
    shown_.reset();
    links_.show(std::nullopt);
}

void RestingView::tick() {
    if (!renderer_) return;
    try {
        if (const int code = renderer_->tick(working_); code != 0 && working_) {
            if (std::exchange(again_, true)) {
                fail(fmt::format("the Renderer ended with exit code {}", code));
            } else {
                interrupt();
            }
        }
    } catch (const rtcore::FileError& error) {
        fail(error.what());
    }
    if (working_ && !watched_) interrupt();
    if (rests_ && watched_ && !begun_ && clock_.seconds() - since_ >= kRest) begin();
}

void RestingView::begin() {
    begun_ = working_ = true;
    const std::string number = std::to_string(run_ % kFiles);
    try {
        const std::string scene = renderer_->file(number + ".scn"), camera = renderer_->file(number + ".cam");
        links_.ask(app::command::exportScene(scene), [this, run = run_](bool done, const std::string& text) {
            if (run == run_ && working_ && !done) fail(text);
        });
        links_.ask(app::command::exportCamera(camera),
                   [this, run = run_, scene, camera](bool done, const std::string& text) {
                       if (run != run_ || !working_) return;
                       done ? exported(run, scene, camera) : fail(text);
                   });
    } catch (const rtcore::FileError& error) {
        fail(error.what());
    }
}

void RestingView::exported(std::uint64_t run, const std::string& scene, const std::string& camera) {
    try {
        renderer_->render(run, scene, camera);
        links_.show(PreviewRun{renderer_->instance(), run, clock_.nanoseconds()});
    } catch (const rtcore::FileError& error) {
        fail(error.what());
    }
}

/// The server's frame stays; the next moment tries again.
void RestingView::fail(const std::string& why) {
    working_ = false;
    shown_.reset();
    links_.show(std::nullopt);
    if (why != std::exchange(told_, why)) links_.note("no images by paths: " + why);
}

void RestingView::progressed(const PreviewProgress& progress) {
    if (!begun_ || progress.run != run_) return;
    shown_ = progress;
    if (!progress.done) return;
    working_ = false;
    told_.clear();
}

} // namespace bridge
