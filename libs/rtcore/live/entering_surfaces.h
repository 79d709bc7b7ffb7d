/// Surfaces that come into a parallel view as the plane in which its rays start moves or turns back across
/// them: they hide what is kept of the frame before.
#pragma once

#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/live/live_samples.h"

#include <vector>

namespace rtcore {

/// Keeps its memory from frame to frame.
class EnteringSurfaces {
  public:
    /// Looks for them by one ray for each square of pixels, in the space that lies before the rays of `now`
    /// and behind those of `before`. Finds none in perspective views. Runs on `threads` threads.
    void find(const ImagePlane& before, const ImagePlane& now, const RayTracer& tracer, int threads);

    /// Whether such surfaces are half of the image of `now` or more, by some rays.
    bool coverHalf(const ImagePlane& before, const ImagePlane& now, const RayTracer& tracer);

    /// Forgets the samples, of the view that find() had as `now`, that they hide in the rows from `first` to
    /// before `last`. Different rows may be given by several threads at once.
    void forgetHidden(LiveLayers& layers, int first, int last) const;

  private:
    /// Memory of a row of squares.
    struct Row {
        RayWave rays;
        HitWave hits;
        std::vector<float> depths; ///< of what is hit; infinite where nothing is
    };
    void findIn(const ImagePlane& before, const ImagePlane& now, const RayTracer& tracer, int row);

    std::vector<Row> rows_;
    Row some_;
    bool any_ = false; ///< rays were traced
};

} // namespace rtcore
