/// Time of each stage of a frame. Off by default: reading the clock costs about 1 % of a fast
/// frame.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>

namespace rtcore {

enum class Stage { Rays, Trace, Surfaces, Occlusion, Light, Shadows, Secondary, Store };
inline constexpr std::size_t kStages = 8;

/// Seconds of all threads together.
struct StageTimes {
    std::array<double, kStages> seconds{}; ///< by Stage

    double of(Stage stage) const { return seconds[static_cast<std::size_t>(stage)]; }
    void add(const StageTimes& other) {
        for (std::size_t i = 0; i < kStages; ++i) seconds[i] += other.seconds[i];
    }
};

/// One for each thread. What passes between two laps belongs to the stage that the second one names.
class StageClock {
  public:
    void start(bool on) {
        on_ = on;
        times_ = {};
        if (on_) last_ = Clock::now();
    }
    void lap(Stage stage) {
        if (!on_) return;
        const Clock::time_point now = Clock::now();
        times_.seconds[static_cast<std::size_t>(stage)] += std::chrono::duration<double>(now - last_).count();
        last_ = now;
    }
    const StageTimes& times() const { return times_; }

  private:
    using Clock = std::chrono::steady_clock;
    bool on_ = false;
    Clock::time_point last_;
    StageTimes times_;
};

} // namespace rtcore
