/// A picture blurred by a Gaussian, at a cost that does not depend on its width.
#pragma once

#include "rtcore/scene/image.h"

#include <vector>

namespace rtcore {

/// Rows and then columns are filtered recursively (Deriche 1993, fourth order: 0.05 % of the peak off the
/// sampled Gaussian). At the borders the picture is mirrored, its last pixels twice, so that a constant stays
/// constant and no light is lost. Keeps its memory from picture to picture; not for several threads at once.
class GaussianBlur {
  public:
    /// `sigma` > 0 in pixels. `blurred` gets the size of `image`, and no value below 0; what is negative or
    /// not a number in `image` counts as 0, infinity as 1e30. `threads` = 0: all cores; the bits are the same
    /// for any number.
    void blur(const HdrImage& image, float sigma, int threads, HdrImage& blurred);

  private:
    /// Of one thread: lines side by side, and what they become.
    struct Lines {
        std::vector<float> values, filtered;
    };
    std::vector<Lines> lines_;
};

} // namespace rtcore
