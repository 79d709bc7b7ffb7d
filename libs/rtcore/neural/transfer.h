/// Between radiance and the numbers that nets take: a curve that is nearly even to the eye over all
/// brightnesses that displays of high dynamic range have (PU21: Mantiuk and Azimi 2021, as Open Image Denoise
/// has it), after a scale by which images of any brightness look alike.
#pragma once

#include <cstddef>

namespace rtcore {

/// Three floats for each pixel, somewhere in memory.
struct PixelPlane {
    const float* first = nullptr; ///< of the upper left pixel; null: there are none
    std::size_t step = 3;         ///< floats from one pixel to the next; rows follow each other
};

/// 0.18 / the mean luminance, as a mean of logarithms, of blocks of some 16 x 16 pixels; blocks without light
/// are left out, and 1 is of an image without any. What is negative or no number counts as 0. The same bits
/// for any number of threads.
float exposureForNet(const PixelPlane& radiance, int width, int height, int threads);

/// values[i] of `radiance` (clamped to 0 ... 65504 after the scale; what is no number is 0) as coded[i], 0 to
/// 1. `count` is a multiple of 16. They may be the same memory.
void encodeRadiance(const float* radiance, std::size_t count, float scale, float* coded);
/// The inverse; what is below 0 or above 1, or no number, is clamped.
void decodeRadiance(const float* coded, std::size_t count, float scale, float* radiance);

} // namespace rtcore
