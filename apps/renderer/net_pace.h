/// How often a net runs over an image that grows.
#pragma once

#include <chrono>

namespace renderer {

/// At most half of the time goes into the net: it runs again when the samples since it last ran took as long
/// as it did then.
class NetPace {
  public:
    using Clock = std::chrono::steady_clock;

    bool due(Clock::time_point now) const { return now >= next_; }
    /// It ran, from `begin` to `end`.
    void ran(Clock::time_point begin, Clock::time_point end) { next_ = end + (end - begin); }

  private:
    Clock::time_point next_;
};

} // namespace renderer
