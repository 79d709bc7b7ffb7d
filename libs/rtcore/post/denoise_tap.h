/// One neighbour of each pixel of a row, for the denoising filter.
#pragma once

#include <cstddef>

namespace rtcore {

/// Rows of pixels, one array for each value.
struct NoisyRow {
    const float *normalX, *normalY, *normalZ; ///< unit; zero for the background
    const float* nearness;                    ///< 1 / depth, 0 for the background
    const float* bright;                      ///< luminance of the light
    const float *red, *green, *blue;          ///< the light
};

struct DenoiseTap {
    NoisyRow pixels, neighbours;
    const float *across, *down; ///< slope of the pixels' nearness, per pixel
    const float* alike;         ///< 1 / the difference of luminance from which on neighbours do not count
    float stepX, stepY;         ///< pixels to the neighbour
    float kernel;               ///< its weight if both pixels were alike
    float tolerance;            ///< fraction of the nearness within which points lie in one plane
    float *weights, *red, *green, *blue; ///< sums, added to
};

/// Adds to the sums of `count` pixels. Vector code; the bits are the same on every processor.
void addTap(const DenoiseTap& tap, std::size_t count);

} // namespace rtcore
