/// When a picture rests, so that its exact image is worth sending. Pure.
#pragma once

#include <algorithm>
#include <array>

namespace bridge {

/// One thread.
class RestWatch {
  public:
    /// A frame of a camera that stands there came; seconds of any clock.
    void frameCame(double now, const float (&eye)[3], const float (&forward)[3]) {
        std::array<float, 6> view{};
        std::copy_n(eye, 3, view.begin());
        std::copy_n(forward, 3, view.begin() + 3);
        if (view != view_) {
            moved_ = now;
            between_ = kFirstBetween;
        }
        view_ = view;
        came_ = now;
        taken_ = false;
    }

    /// Whether to make the exact image of the newest frame now; true once for each frame at most. Where a
    /// resting picture goes on improving, at some of its steps, and at the last one, when the server is idle.
    bool takeStill(double now, bool idle) {
        if (taken_ || now - came_ < kQuiet) return false;
        const bool step = now - moved_ > kStands && now - lastStill_ > between_;
        if (!idle && !step) return false;
        if (!idle) between_ = std::min(2 * between_, kLongestBetween);
        lastStill_ = now;
        taken_ = true;
        return true;
    }

  private:
    static constexpr double kQuiet = 0.12, kStands = 0.5, kFirstBetween = 1, kLongestBetween = 8;
    std::array<float, 6> view_{};
    double moved_ = -1e9, came_ = -1e9, lastStill_ = -1e9, between_ = kFirstBetween;
    bool taken_ = true;
};

} // namespace bridge
