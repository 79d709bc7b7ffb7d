/// The picture of samples, which not every pixel has, and which lie anywhere in theirs.
#pragma once

#include "rtcore/live/live_samples.h"
#include "rtcore/live/sample_means.h"
#include "rtcore/render/frame.h"

#include <vector>

namespace rtcore {

/// Keeps its memory from frame to frame.
class SamplePicture {
  public:
    /// Writes frame.radiance and frame.covered, whose size is that of the samples: each pixel shows the light
    /// of the samples around its middle, the nearer the more, within one pixel; or, where there is none, what
    /// is seen around it. Where all samples are in the middles of their pixels, each shows its own.
    void show(const LiveLayers& samples, int threads, Frame& frame);

  private:
    /// A few rows of light, with what each sample weighs in the pixels beside. Of one thread.
    struct Rows {
        std::vector<float> values;
    };
    /// Returns whether there are pixels around which nothing is known: their light is below 0.
    bool showRows(const LiveLayers& samples, int first, int last, Rows& rows, Frame& frame) const;

    std::vector<Rows> rows_; ///< by thread
    SampleMeans means_;
};

} // namespace rtcore
