/// Exposure that follows the surroundings of each pixel, as an eye adapts to the part of a view that it looks
/// at.
#pragma once

#include "rtcore/post/effect.h"
#include "rtcore/scene/image.h"

#include <cstddef>
#include <vector>

namespace rtcore {

/// The brightness around each pixel is the average of the logarithm of luminance, up to edges: a guided
/// filter (He, Sun and Tang 2013) with the image as its own guide, worked out on an image of some 200
/// columns (He and Sun 2015). So a dark room beside a bright window gets brighter up to the window's frame,
/// without a halo. Radiance is multiplied by (average / brightness around the pixel)^exposure.local, where
/// `average` is the luminance that the exposure of the whole image suits: with it, that exposure suits each
/// pixel.
class LocalExposure final : public Effect {
  public:
    bool beginRows(const HdrImage& coarse, int block, const EffectRun& run) override;
    void changeRow(const RowPart& part, const Colour* radiance, Colour* changed) const override;

  private:
    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x);
    }
    void measure(const HdrImage& picture, int threads);
    void average(std::vector<float>& values);

    int columns_ = 0, rows_ = 0;
    float strength_ = 0;                ///< 0..1
    float scale_ = 1;                   ///< of luminance, so that the average is 1
    std::vector<float> slope_, offset_; ///< brightness around = slope * pixel + offset, in powers of two
    std::vector<float> squares_, sums_;
};

extern const EffectRow kLocalExposureEffect;

} // namespace rtcore
