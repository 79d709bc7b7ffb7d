/// Exposure that follows the surroundings of each place, as an eye adapts to the part of a view that it looks
/// at.
#pragma once

#include "rtcore/scene/image.h"

#include <cstddef>
#include <vector>

namespace rtcore {

/// The brightness around each pixel is the average of the logarithm of luminance, up to edges: a guided
/// filter (He, Sun and Tang 2013) with the picture as its own guide, worked out on a picture of some 200
/// columns (He and Sun 2015). So a dark room beside a bright window gets brighter up to the window's frame,
/// without a halo. Keeps its memory; one thread at a time may call measure(), any number factors().
class LocalExposure {
  public:
    /// `average`: the luminance that the exposure of the whole picture suits. `threads` = 0: all cores; the
    /// bits are the same for any number.
    void measure(const HdrImage& picture, float average, int threads);

    /// Radiance of row `y` of a picture of `width` x `height`, from column `left` to before `right`, times
    /// (average / brightness around the pixel)^strength: with it, the exposure of the whole picture suits
    /// each place. 0 <= strength <= 1. The picture may be a larger one than the measured one, of the same
    /// view. `adjusted` and `radiance` begin at column 0 and may be the same.
    void adjust(const Colour* radiance, int left, int right, int y, int width, int height, float strength,
                Colour* adjusted) const;

    bool measured() const { return columns_ > 0; }

  private:
    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x);
    }
    void average(std::vector<float>& values);

    int columns_ = 0, rows_ = 0;
    float scale_ = 1;                   ///< of luminance, so that the average is 1
    std::vector<float> slope_, offset_; ///< brightness around = slope * pixel + offset, in powers of two
    std::vector<float> squares_, sums_;
};

} // namespace rtcore
