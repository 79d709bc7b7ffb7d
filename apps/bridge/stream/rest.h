/// The selection of frames while the view stands still: which steps of an image that keeps improving are
/// worth showing, and when an exact image is worth sending. Pure.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

namespace bridge {

/// Where a frame stands among others.
struct FrameStep {
    std::uint64_t epoch = 0, run = 0; ///< which server and which of its runs
    std::uint32_t width = 0, height = 0;
    std::uint32_t samples = 0;   ///< a pixel; 0: several pixels share one
    std::uint64_t tag = 0;       ///< of a preview: how far it is
    std::array<float, 6> view{}; ///< of the camera: eye and direction

    bool sameView(const FrameStep& other) const {
        return epoch == other.epoch && run == other.run && width == other.width && height == other.height &&
               view == other.view;
    }
    /// Whether it shows what `before` does, only better. Frames of another light or setting have no more
    /// samples than those before, and are none.
    bool improves(const FrameStep& before) const {
        return sameView(before) && (tag > before.tag || (before.samples > 0 && samples > before.samples));
    }
};

/// One thread; seconds of any clock that is never set.
class RestWatch {
  public:
    /// A frame came. True: it is to be shown now. False: it only improves what is shown, and may wait: ask
    /// due(). Call shown() when it is shown.
    bool comes(double now, const FrameStep& step) {
        if (!step.sameView(newest_)) {
            moved_ = now;
            betweenStills_ = kFirstBetweenStills;
        }
        improves_ = step.improves(newest_);
        if (!improves_) between_ = kFirstBetween;
        newest_ = step;
        return due(now, false);
    }
    /// Whether a frame that waits is to be shown now. `idle`: the server says that no better one follows.
    bool due(double now, bool idle) const { return !improves_ || idle || now - shown_ >= between_; }
    void shown(double now) {
        if (improves_) between_ = std::min(2 * between_, kLongestBetween);
        shown_ = now;
        taken_ = false;
    }

    /// Whether to make the exact image of the frame that is shown now; true once for each at most. Where a
    /// resting picture goes on improving, at some of its steps, and at the last one, when the server is idle.
    bool takeStill(double now, bool idle) {
        if (taken_ || now - shown_ < kQuiet) return false;
        const bool step = now - moved_ > kStands && now - lastStill_ > betweenStills_;
        if (!idle && !step) return false;
        if (!idle) betweenStills_ = std::min(2 * betweenStills_, kLongestBetween);
        lastStill_ = now;
        taken_ = true;
        return true;
    }

  private:
    static constexpr double kQuiet = 0.12, kStands = 0.5;
    static constexpr double kFirstBetween = 0.1, kFirstBetweenStills = 1, kLongestBetween = 8;
    FrameStep newest_;
    double moved_ = -1e9, shown_ = -1e9, lastStill_ = -1e9;
    double between_ = kFirstBetween, betweenStills_ = kFirstBetweenStills;
    bool improves_ = false, taken_ = true;
};

} // namespace bridge
