/// Shows on stderr how far a long job is, and passes a stop signal on to it.
#pragma once

#include "common/cli/options.h"
#include "common/progress/progress_format.h"

#include "rtcore/platform/sentence.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

namespace app {

enum class ProgressStyle {
    Bar,   ///< one line that is drawn again and again, for terminals
    Plain, ///< a line now and then, for logs; nothing for jobs of a second or two
    Json,  ///< an object a line (progress_format.h), for programs
    None,
};

/// The --progress option, and what its value stands for ("auto": Bar on a terminal, else Plain).
Option progressOption();
ProgressStyle progressStyle(std::string_view word);

/// One stage of the job.
struct ProgressPhase {
    std::string name;                    ///< a participle: "rendering"
    std::function<double()> fraction;    ///< 0..1, called from another thread; empty = not known
    std::atomic<bool>* cancel = nullptr; ///< set when a signal asks to stop
};

/// A thread of its own shows the current phase ten times a second, and passes a signal on within some
/// milliseconds. begin, end and print may be called from
/// any one thread. What a phase refers to must live until end() or the next begin().
class Progress {
  public:
    Progress(std::string program, ProgressStyle style);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// `frame` of `frames` (from 1): the time left is then that of all frames since the first of them began.
    void begin(ProgressPhase phase, int frame = 0, int frames = 0);
    /// `finished`: the phase came to its good end.
    void end(bool finished = true);

    /// "Program: text" on a line of its own, without tearing the bar.
    void print(std::string_view text);
    void tell(const rtcore::Sentence& said); ///< printSentence()

  private:
    using Clock = std::chrono::steady_clock;

    void watch(const std::stop_token& stop);
    ProgressState state(Clock::time_point now) const;
    void show(Clock::time_point now, bool always);
    void showPlain(const ProgressState& moment, Clock::time_point now);
    void draw(const std::string& text);
    void eraseBar();

    const std::string program_;
    const ProgressStyle style_;
    std::mutex mutex_; ///< guards all below
    std::condition_variable_any wake_;
    bool active_ = false;
    ProgressPhase phase_;
    int frame_ = 0, frames_ = 0;
    Clock::time_point begun_; ///< of the phase, or of the first frame
    Clock::time_point shown_; ///< of the last line
    double shownFraction_ = -1;
    bool barVisible_ = false;
    std::jthread thread_; ///< last: it starts when all else stands
};

/// A phase from here to the end of the block; left by an exception, it counts as not finished.
class ProgressScope {
  public:
    ProgressScope(Progress& progress, ProgressPhase phase, int frame = 0, int frames = 0)
        : progress_(progress), exceptions_(std::uncaught_exceptions()) {
        progress_.begin(std::move(phase), frame, frames);
    }
    ~ProgressScope() { progress_.end(std::uncaught_exceptions() == exceptions_); }
    ProgressScope(const ProgressScope&) = delete;
    ProgressScope& operator=(const ProgressScope&) = delete;

  private:
    Progress& progress_;
    int exceptions_;
};

} // namespace app
