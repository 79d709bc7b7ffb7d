/// Which frame comes next, and when it is left before its end: nothing freezes.
#pragma once

#include "rtserver/frames/detail_governor.h"
#include "rtserver/frames/live_governor.h"

#include <chrono>

namespace rtserver {

/// One thread at a time. A change is seen in a frame that is quick enough, as far as one can tell, and never
/// left for another change: so there always is a next one. Where it takes so long that the coarsest one
/// would come later than two frame times after the change, that takes its place. A live frame is never left:
/// it is known better what it takes. The whole frame follows, and is left as soon as something changes. One
/// that a command waits for is left after a second only.
///
/// Where frames may take any time, all of them are whole. One that takes more than a second is left for a
/// change, and the coarsest is seen in its place.
class FrameSchedule {
  public:
    using Duration = std::chrono::steady_clock::duration;

    struct Demand {
        bool changed = true;     ///< since the last frame that was shown
        bool waitedFor = false;  ///< a command needs the whole frame
        double frameSeconds = 0; ///< that the frame after a change may take; 0 = any time
        DetailGovernor::Work work;
        /// Whether there are live frames in place of coarse ones, and what of them LiveGovernor asks for.
        bool live = false;
        double pixels = 0, liveRays = 0;
    };

    /// A frame is drawn now. Call left() or shown() when it is over.
    FrameDetail begin(const Demand& demand);
    /// Whether it is left now that it has lasted so long. `changeWaits`: something changed meanwhile.
    bool leaves(Duration lasted, bool changeWaits) const;
    void left(Duration lasted);
    /// `live`: of a live frame, but for LiveGovernor::Cost::seconds, which are those of `lasted`.
    void shown(Duration lasted, LiveGovernor::Cost live = {});
    /// Whether a frame was left before its change was seen.
    bool owes() const { return owed_; }
    /// Seconds that the coarsest frames take at most, as far as is known; 0 = not yet known.
    double coarsest() const { return coarsest_; }
    /// The next frame is of another scene.
    void forget();

  private:
    FrameDetail choose() const;
    FrameDetail chooseLive() const;
    double patience() const;

    DetailGovernor governor_;
    LiveGovernor liveGovernor_;
    Demand demand_; ///< of the frame that is drawn
    FrameDetail detail_;
    bool owed_ = false;   ///< a frame was left before its change was seen
    bool rested_ = false; ///< the last frame that was drawn is whole, and was shown
    double coarsest_ = 0;
};

} // namespace rtserver
