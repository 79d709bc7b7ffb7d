/// Where the samples of a pixel lie in it.
#pragma once

#include "rtcore/sampling/sample_id.h"
#include "rtcore/settings/render_settings.h"

#include <vector>

namespace rtcore {

/// n x n points for each pixel. The sample number row * n + column lies in or near that cell of a grid of n x
/// n, apart from those at random: what is near in number is near in the image. A sample is where it was in
/// the last frame.
///
/// Grid: the middles of the cells; Rotated: each in a row and a column of its own, as if the grid were turned
/// by a small angle; both the same in every pixel. Jittered: anywhere in its cell. Random: anywhere. Poisson:
/// at random, but far from each other, on a torus that is shifted in each pixel.
class PixelPattern {
  public:
    /// Comes before all else. n: 1..16. Keeps what it has when it is asked for the same again.
    void prepare(SamplingPattern pattern, int n);

    SamplingPattern pattern() const { return pattern_; }
    /// Right and down from the upper left corner of the pixel, in pixels.
    SquarePoint at(SampleId id) const;

  private:
    SamplingPattern pattern_ = SamplingPattern::Grid;
    int n_ = 0;                       ///< 0: not prepared
    std::vector<SquarePoint> points_; ///< those that all pixels share
};

/// The point (column, row) of a rotated grid of n x n.
SquarePoint rotatedGridPoint(int column, int row, int n);

} // namespace rtcore
