/// Luminance or illuminance as colours, with lines where it is equal.
#pragma once

#include "rtcore/post/value_scale.h"
#include "rtcore/render/pixel_area.h"
#include "rtcore/scene/image.h"

#include <cstddef>
#include <vector>

namespace rtcore {

/// How an image is shown by them.
struct FalseColours {
    ValueScale scale;
    LightQuantity quantity = LightQuantity::Luminance;
    LuminanceUnit unit; ///< shownUnit() of the quantity
    /// Of illuminance, whether pixels where no surface is seen are below 0 (PictureDeveloper::finish()). Else
    /// all black ones count as such.
    bool marked = false;
    bool isolines = true;
    bool legend = true; ///< for paintLegend()
};

/// Rows of an image that are painted together: each other number gives the same image, but costs more.
inline constexpr int kFalseColourRows = 32;

/// Where no surface is seen.
inline constexpr Rgba8 kNoValue{96, 96, 96, 255};

/// The values that have an isoline, and a number in the legend.
std::vector<float> isovalues(const ValueScale& scale);

/// Keeps the memory of one thread.
class FalseColourPainter {
  public:
    /// Rows from `first` to before `last` of `part`, opaque, into `image` of the size of `radiance`. Each
    /// pixel has the colour of its own luminance (value_colours.h); what is beyond the scale, that of its
    /// ends. Where no surface is seen (FalseColours::marked), it is kNoValue, without isolines around.
    /// Isolines are one pixel wide and lie where the logarithm of luminance, smoothed over some three pixels,
    /// has a value of isovalues(). They fade where they would lie less than some five pixels apart, as at
    /// edges of objects, and where luminance is even. Reads pixels of `part` alone: at its borders lines may
    /// be thinner.
    void paint(const HdrImage& radiance, const FalseColours& how, const PixelArea& part, int first, int last,
               LdrImage& image);

  private:
    struct Band;
    void smooth(const Band& band);

    std::vector<float> logs_, across_, smooth_;
};

/// Bytes that the painters of so many threads keep for images of so many columns.
std::size_t falseColourBytes(int columns, int threads);

/// All of a part by the calling thread.
void paintFalseColours(const HdrImage& radiance, const FalseColours& how, const PixelArea& part,
                       LdrImage& image);

} // namespace rtcore
