#include "common/progress/progress.h"

#include "common/process/message.h"
#include "common/process/stop.h"
#include "common/process/terminal.h"

#include <algorithm>
#include <utility>

namespace app {

namespace {

using namespace std::chrono_literals;

constexpr auto kLook = 5ms;           // for a signal that asks to stop
constexpr auto kTick = 100ms;         // between two images of the bar
constexpr auto kQuiet = 200ms;        // a shorter job draws no bar
constexpr auto kPlainInterval = 2s;   // between two lines of a log
constexpr auto kPlainHeartbeat = 30s; // a log shows life even when little moves
constexpr double kPlainStep = 0.1;

double seconds(std::chrono::steady_clock::duration time) {
    return std::chrono::duration<double>(time).count();
}

} // namespace

Option progressOption() {
    return {.name = "progress",
            .value = ValueKind::Choice,
            .argument = "STYLE",
            .help = "how progress is shown on stderr: bar, plain (lines), json (one object a line), none, or "
                    "auto (bar on a terminal, else plain) [auto]",
            .choices = {"auto", "bar", "plain", "json", "none"}};
}

ProgressStyle progressStyle(std::string_view word) {
    if (word == "bar") return ProgressStyle::Bar;
    if (word == "plain") return ProgressStyle::Plain;
    if (word == "json") return ProgressStyle::Json;
    if (word == "none") return ProgressStyle::None;
    return terminalColumns() ? ProgressStyle::Bar : ProgressStyle::Plain;
}

Progress::Progress(std::string program, ProgressStyle style)
    : program_(std::move(program)), style_(style),
      thread_([this](const std::stop_token& stop) { watch(stop); }) {}

Progress::~Progress() {
    thread_.request_stop();
    thread_.join();
    eraseBar();
}

void Progress::begin(ProgressPhase phase, int frame, int frames) {
    const std::lock_guard lock(mutex_);
    const auto now = Clock::now();
    const bool nextFrame = frame > 1 && frames == frames_;
    if (!nextFrame) {
        begun_ = now;
        shown_ = now;
        shownFraction_ = 0;
    }
    phase_ = std::move(phase);
    frame_ = frame;
    frames_ = frames;
    active_ = true;
    if (style_ == ProgressStyle::Json) show(now, true);
}

void Progress::end(bool finished) {
    const std::lock_guard lock(mutex_);
    if (!active_) return;
    phase_.cancel = nullptr;
    phase_.fraction = [] { return 1.0; };
    if (style_ == ProgressStyle::Json && finished) show(Clock::now(), true);
    phase_.fraction = nullptr;
    active_ = false;
    eraseBar();
}

void Progress::print(std::string_view text) {
    const std::lock_guard lock(mutex_);
    eraseBar();
    printMessage(program_, text);
}

void Progress::tell(const rtcore::Sentence& said) {
    const std::lock_guard lock(mutex_);
    eraseBar();
    printSentence(program_, said);
}

void Progress::watch(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    Clock::time_point next = Clock::now() + kTick;
    while (!stop.stop_requested()) {
        wake_.wait_for(lock, stop, kLook, [] { return false; });
        if (!active_) continue;
        if (stopRequested() && phase_.cancel != nullptr) phase_.cancel->store(true);
        const Clock::time_point now = Clock::now();
        if (now < next) continue;
        show(now, false);
        next = now + kTick;
    }
}

ProgressState Progress::state(Clock::time_point now) const {
    ProgressState result{
        .phase = phase_.name, .fraction = {}, .frame = frame_, .frames = frames_, .secondsLeft = {}};
    if (!phase_.fraction) return result;
    double fraction = std::clamp(phase_.fraction(), 0.0, 1.0);
    if (frames_ > 0) fraction = (frame_ - 1 + fraction) / frames_;
    result.fraction = fraction;
    const double elapsed = seconds(now - begun_);
    if (fraction > 0 && elapsed > 0.5) result.secondsLeft = elapsed * (1 - fraction) / fraction;
    return result;
}

void Progress::show(Clock::time_point now, bool always) {
    if (style_ == ProgressStyle::None) return;
    const ProgressState moment = state(now);
    const double fraction = moment.fraction.value_or(0);
    switch (style_) {
    case ProgressStyle::Bar:
        if (barVisible_ || now - begun_ >= kQuiet) draw(barText(moment, terminalColumns().value_or(80)));
        break;
    case ProgressStyle::Plain:
        showPlain(moment, now);
        break;
    case ProgressStyle::Json:
        if (always || fraction != shownFraction_) writeError(jsonText(moment) + "\n");
        shownFraction_ = fraction;
        break;
    case ProgressStyle::None:
        break;
    }
}

void Progress::showPlain(const ProgressState& moment, Clock::time_point now) {
    const double fraction = moment.fraction.value_or(0);
    const bool moved = fraction >= shownFraction_ + kPlainStep;
    if (now - shown_ < (moved ? Clock::duration(kPlainInterval) : Clock::duration(kPlainHeartbeat))) return;
    printMessage(program_, plainText(moment));
    shown_ = now;
    shownFraction_ = fraction;
}

void Progress::draw(const std::string& text) {
    writeError("\r" + text + "\x1b[K");
    barVisible_ = true;
}

void Progress::eraseBar() {
    if (barVisible_) writeError("\r\x1b[K");
    barVisible_ = false;
}

} // namespace app
