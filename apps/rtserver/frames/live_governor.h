/// Chooses how many pixels of a live frame (rtcore/live) are traced in the time that it may take, and how
/// large it is.
#pragma once

#include "rtserver/frames/frame_detail.h"

namespace rtserver {

/// One thread. Knows from frames before it what a traced pixel takes, what each pixel takes besides, and what
/// a ray takes by which indirect light is learned. First traced pixels give way, down to kWantedSamples of
/// them; then those rays, down to kMinLearning of them; then the size, by twelfths; then traced pixels again,
/// down to kMinSamples. Light that is older than 50 frames is worse than few pixels.
class LiveGovernor {
  public:
    /// The cost of a live frame.
    struct Cost {
        double samples = 0;       ///< traced pixels
        double sampleSeconds = 0; ///< that they took
        double rays = 0;          ///< by which indirect light was learned
        double raySeconds = 0;    ///< that they took
        double seconds = 0;       ///< of the whole frame, its display included
    };

    /// For a frame that may take `target` > 0 seconds. `pixels`: of a frame at full size; `rays`: about those
    /// of a traced pixel, from which its time is guessed as long as it is not known.
    FrameDetail detail(double pixels, double rays, double target) const;
    /// Such a frame took so long. `target`: as above.
    void learn(const FrameDetail& detail, double pixels, double target, const Cost& cost);
    /// The next frame is of another scene.
    void forget() { *this = {}; }

  private:
    double minSeconds(double pixels, double scale) const;
    double learningSeconds() const;

    double scale_ = 1;
    double secondsPerSample_ = 0; ///< 0: not known
    double secondsPerPixel_ = 0;
    double secondsPerRay_ = 0; ///< 0: no indirect light is learned
};

} // namespace rtserver
