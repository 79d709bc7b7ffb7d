/// How often an image that grows is shown.
#pragma once

#include <algorithm>
#include <chrono>

namespace renderer {

/// Ten times a second; more seldom where showing would take more than a fortieth of the time of one core, but
/// once a second at least.
class PreviewPace {
  public:
    using Clock = std::chrono::steady_clock;

    bool due(Clock::time_point now) const { return now >= next_; }
    /// It was shown, from `begin` to `end`.
    void shown(Clock::time_point begin, Clock::time_point end) {
        next_ = end + std::clamp<Clock::duration>(kRest * (end - begin), kShortest, kLongest);
    }

  private:
    static constexpr std::chrono::milliseconds kShortest{100};
    static constexpr std::chrono::seconds kLongest{1};
    static constexpr int kRest = 40;

    Clock::time_point next_;
};

} // namespace renderer
