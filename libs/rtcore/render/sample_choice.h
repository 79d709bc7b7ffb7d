/// Adaptive sampling: a part of each pixel's samples first, and the others only where these differ.
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
/// How many these are.
int firstSamples(int n);

/// Whether the settings ask for it, and there is something to choose.
bool choosesSamples(const RenderSettings& settings);

/// Of one frame. Differences are measured as the display shows them: of the square root of L = Y / (Y + c)
/// for each colour, where c is the exposure which shows the mean of the first samples as the key. The mode of
/// exposure has no part in it: a frame of the live view and its .cam, which fixes what the live view had
/// reached, choose the same samples. A pixel's error is the largest difference between its own samples, or
/// between its mean and that of a pixel beside, above or below it.
///
/// begin(); add() for all first samples; measure(); choose() for all pixels; chosen(). What is for different
/// pixels may run at once.
class SampleChoice {
  public:
    /// Keeps its memory from frame to frame.
    void begin(const RenderSettings& settings);
    /// One of the first samples.
    void add(int x, int y, Colour radiance);
    /// `sums`: of all first samples of each pixel.
    void measure(const HdrImage& sums);
    void choose(const PixelArea& area, const HdrImage& sums);
    /// Whether the pixel gets the rest of its samples.
    bool chosen(int x, int y) const { return chosen_[at(x, y)] != 0; }

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
    float share_ = 1; ///< 1 / samples that come first
    std::vector<Extent> extents_;
    std::vector<std::uint8_t> chosen_;
};

} // namespace rtcore
