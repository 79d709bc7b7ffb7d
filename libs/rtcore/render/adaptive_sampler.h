/// Adaptive sampling: a quarter of each pixel's samples first, the others only where these differ.
#pragma once

#include "rtcore/render/pixel_area.h"
#include "rtcore/scene/image.h"
#include "rtcore/settings/render_settings.h"

#include <cstdint>
#include <vector>

namespace rtcore {

/// Which of a pixel's n x n samples come first: one of each 2 x 2 cells, rows and columns changing, so that
/// they are spread as evenly as all of them.
bool isFirstSample(std::uint32_t sub, int n);
/// Their number.
int firstSamples(int n);

/// Whether the settings ask for it, and there is something to choose.
bool samplesAdaptively(const RenderSettings& settings);

/// Adaptive sampling of one frame. Differences are measured as the display shows them: of the square root of
/// L = Y / (Y + c) for each colour, where c is the exposure which shows the mean of the first samples as the
/// key. The mode of exposure is not used, so that a frame of the live view and a rendering of its .cam, which
/// fixes the exposure of that moment, refine the same pixels. A pixel's error is the largest difference
/// between its own samples, or between its mean and that of a pixel beside, above or below it.
///
/// Order of calls: begin(); add() for all first samples; measure(); choose() for all pixels; refined(). Calls
/// for different pixels may run at once.
class AdaptiveSampler {
  public:
    /// Keeps its memory from frame to frame.
    void begin(const RenderSettings& settings);
    /// One of the first samples.
    void add(int x, int y, Colour radiance);
    /// `sums`: of all first samples of each pixel.
    void measure(const HdrImage& sums);
    void choose(const PixelArea& area, const HdrImage& sums);
    /// Whether the pixel gets the rest of its samples.
    bool refined(int x, int y) const { return refined_[at(x, y)] != 0; }

  private:
    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }
    Colour shown(Colour radiance) const;
    float error(int x, int y, const HdrImage& sums) const;

    struct Extent {
        Colour lowest, highest;
    };
    int width_ = 0, height_ = 0;
    float threshold_ = 0, exposure_ = 1, key_ = 1;
    float fraction_ = 1; ///< 1 / samples that come first
    std::vector<Extent> extents_;
    std::vector<std::uint8_t> refined_;
};

} // namespace rtcore
