/// When the next frame is due, and how many came within the last second.
#pragma once

#include <algorithm>
#include <chrono>
#include <deque>

namespace rtserver {

/// One thread. Knows time only by what it is told.
class FramePacer {
  public:
    using Clock = std::chrono::steady_clock;

    /// At most so many frames per second; 0: as many as there are.
    explicit FramePacer(double framesPerSecond) : framesPerSecond_(framesPerSecond) {}

    /// Time between frames at least; 0: there may be as many as there are.
    Clock::duration interval() const;
    /// No frame before that. `adapting`: it differs from the last by its exposure alone, and need not come at
    /// once.
    Clock::time_point due(bool adapting) const { return adapting ? std::max(due_, adapted_) : due_; }
    /// Puts the next frame off.
    void pauseUntil(Clock::time_point time) { due_ = time; }
    /// A frame that was begun then is published now.
    void published(Clock::time_point begun, Clock::time_point now);
    /// Published within the last second.
    double framesPerSecond(Clock::time_point now) const;

  private:
    double framesPerSecond_;
    Clock::time_point due_, adapted_;
    Clock::time_point beat_;                  ///< when the next frame would be due if none were ever late
    std::deque<Clock::time_point> published_; ///< within the second before the last of them
};

} // namespace rtserver
