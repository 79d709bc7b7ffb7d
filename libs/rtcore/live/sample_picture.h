/// The picture of samples, which not every pixel has.
#pragma once

#include "rtcore/live/live_samples.h"
#include "rtcore/live/sample_means.h"
#include "rtcore/render/frame.h"

namespace rtcore {

/// Keeps its memory from frame to frame.
class SamplePicture {
  public:
    /// Writes frame.radiance and frame.covered, whose size is that of the samples: each pixel shows the light
    /// of its sample, or, where it has none, what is seen around it.
    void show(const LiveSamples& samples, int threads, Frame& frame);

  private:
    SampleMeans means_;
};

} // namespace rtcore
