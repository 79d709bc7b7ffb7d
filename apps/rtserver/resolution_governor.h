/// Dynamic resolution: as many pixels as can be drawn in the time that a frame may take.
#pragma once

namespace rtserver {

/// One thread. Assumes that the time of a frame grows with its number of pixels; is quick to give up pixels
/// and slow to take them back.
class ResolutionGovernor {
  public:
    /// A frame of `scale` times the full width and height took so long; `target` > 0, seconds.
    void learn(double seconds, double scale, double target);
    /// For the next frame: 1/8 to 1, in sixteenths, so that sizes do not change with every frame.
    double scale() const;

  private:
    double wanted_ = 1;
};

} // namespace rtserver
