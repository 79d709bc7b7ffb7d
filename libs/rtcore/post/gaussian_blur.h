/// An image blurred by a Gaussian, at a cost that does not depend on its width.
#pragma once

#include "rtcore/scene/image.h"

#include <vector>

namespace rtcore {

/// Rows and then columns are filtered recursively (Deriche 1993, fourth order: 0.05 % of the peak off the
/// sampled Gaussian). At the borders the image is mirrored, its last pixels twice, so that a constant stays
/// constant and no light is lost. Keeps its memory from image to image; not for several threads at once.
class GaussianBlur {
  public:
    /// result = (1 - fraction) image + fraction blurred, of the size of `image`. `sigma` > 0 in pixels,
    /// `fraction` in 0..1. Nothing blurred is below 0; of what is blurred, negative and not a number count as
    /// 0, infinity as 1e30. `threads` = 0: all cores; the bits are the same for any number.
    void blur(const HdrImage& image, float sigma, float fraction, int threads, HdrImage& result);

  private:
    /// Buffers of one thread: lines side by side, before and after the filter.
    struct Lines {
        std::vector<float> values, filtered;
    };
    std::vector<Lines> lines_;
};

} // namespace rtcore
