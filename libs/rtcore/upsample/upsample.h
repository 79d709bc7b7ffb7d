/// Upsampling of images along their edges: what was drawn with few pixels is shown soft, without squares.
#pragma once

#include "rtcore/scene/image.h"

#include <cstddef>
#include <cstdint>

namespace rtcore {

/// An image of four bytes a pixel, encoded for a display, in memory of someone else. Red and blue may be the
/// other way round. The fourth byte is not read, and is written as 255.
template <typename Byte>
struct BytePixels {
    Byte* first = nullptr;
    int width = 0, height = 0;
    std::ptrdiff_t stride = 0; ///< bytes from row to row
};

/// How many pixels of the large image one of the small image is wide and high: 1 or more.
struct UpsamplingScale {
    float across, down;
};

/// Fills `image`, whose edges are those of `small`; both have pixels, and share none. `threads` = 0: all
/// cores.
///
/// A pixel is a mean of the 4 x 4 pixels of the small image around it. Where these have no edge,
/// their weights fall off evenly to all sides; across an edge they fall off sooner, along it later, as the
/// structure tensor tells (Foerstner and Guelch 1987): staircases become slanting lines. No channel is above
/// or below all those that it is made of. The same bits for any number of threads and any instruction set.
/// Each thread needs memory for a few rows.
void upsample(BytePixels<const std::uint8_t> small, int threads, BytePixels<std::uint8_t> image);
void upsample(const LdrImage& small, int threads, LdrImage& image);
/// As that, where the images share no more than their upper left corner.
void upsample(const LdrImage& small, UpsamplingScale scale, int threads, LdrImage& image);
/// As that, of radiance: bright light weighs as on a display. What is no number or below 0 counts as black,
/// what is more than some 25,000 times the log-average as that.
void upsample(const HdrImage& small, int threads, HdrImage& image);

} // namespace rtcore
