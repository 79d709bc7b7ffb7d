/// Chooses how many pixels of a live frame (rtcore/live) are traced in the time that it may take, and how
/// large it is.
#pragma once

#include "rtserver/frames/frame_detail.h"

#include <array>

namespace rtserver {

/// One thread. Knows from frames before it what a traced pixel takes, what each pixel takes besides, and what
/// a ray takes by which indirect light is learned. First traced pixels give way, down to kWantedSamples of
/// them; then those rays, down to kMinLearning of them; then the size, by twelfths; then traced pixels again,
/// down to kMinSamples. Light that is older than 50 frames is worse than few pixels. A frame after one that
/// knew little of what it saw may learn by up to four times those rays, where there is time for them beside
/// kWantedSamples.
class LiveGovernor {
  public:
    /// The cost of a live frame.
    struct Cost {
        double samples = 0;       ///< traced pixels
        double sampleSeconds = 0; ///< that they took
        double rays = 0;          ///< by which indirect light was learned
        double raySeconds = 0;    ///< that they took
        double unknown = 0;       ///< the part of what was seen that it knew little of
        double seconds = 0;       ///< of the whole frame, its display included
    };

    /// For a frame that may take `target` > 0 seconds. `pixels`: of a frame at full size; `rays`: about those
    /// of a traced pixel, from which its time is guessed as long as it is not known.
    FrameDetail detail(double pixels, double rays, double target) const;
    /// FrameDetail::learning of a coarse frame: by rays that take about half of its time.
    double coarseLearning(double target) const;
    /// Rays of a coarse frame took so long.
    void learnRays(const Cost& cost);
    /// Such a frame took so long. `target`: as above.
    void learn(const FrameDetail& detail, double pixels, double target, const Cost& cost);
    /// The next frame is of another scene.
    void forget() { *this = {}; }

  private:
    /// What a unit of work takes. A frame counts as twice as slow as the two before it at most: one in which
    /// another program had the processor says nothing of its size.
    class Rate {
      public:
        void learn(double now);
        double seconds() const { return known_; } ///< 0: not known

      private:
        double known_ = 0;
        std::array<double, 2> before_{}; ///< the last and the one before it; 0: there was none
    };

    double minSeconds(double pixels, double scale) const;
    double learningSeconds() const;

    double scale_ = 1;
    Rate sample_, pixel_;
    Rate ray_;           ///< not known: no indirect light is learned
    double unknown_ = 0; ///< of the last frame
};

} // namespace rtserver
