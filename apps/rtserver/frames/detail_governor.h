/// Chooses how much of a frame can be drawn in the time that it may take.
#pragma once

#include "rtserver/frames/frame_detail.h"

namespace rtserver {

/// One thread. Knows from frames before it how much work a second does. Coarse frames do less of it, since
/// their rays lie further apart, so they and whole ones are remembered apart. Quick to give detail up and
/// slow to take it back.
class DetailGovernor {
  public:
    /// Frames with all samples and with few of them, as workOf() counts both at full size.
    struct Work {
        double whole = 1, cut = 1;
    };

    /// For a frame that may take `target` > 0 seconds. The coarsest while nothing is known. Sizes go in
    /// sixteenths, so that they do not change with every frame.
    FrameDetail detail(const Work& work, double target) const;
    /// Such a frame took so long.
    void learn(const FrameDetail& detail, const Work& work, double seconds);
    /// Such a frame would have taken longer than that.
    void learnLimit(const FrameDetail& detail, const Work& work, double seconds);
    /// The next frame is of another scene.
    void forget() { wholePace_ = pace_ = 0; }

  private:
    double& paceOf(const FrameDetail& detail) { return detail.whole() ? wholePace_ : pace_; }

    // Roots of work a second: they grow with the sides of an image. 0: not known.
    double wholePace_ = 0;
    double pace_ = 0;
};

} // namespace rtserver
