/// Shifts for the patterns of an image's samples: each as random as randomShift(), but neighbours differ, so
/// that noise is fine and evens out over a few pixels.
#pragma once

#include "rtcore/sampling/sample_id.h"

#include <cstdint>

namespace rtcore {

/// Place of a cell on Hilbert's curve through 64 x 64 of them; x, y < 64.
constexpr std::uint32_t hilbertIndex(std::uint32_t x, std::uint32_t y) {
    std::uint32_t index = 0;
    for (std::uint32_t half = 32; half > 0; half /= 2) {
        const bool right = (x & half) != 0, lower = (y & half) != 0;
        index += half * half * ((right ? 3U : 0U) ^ (lower ? 1U : 0U));
        if (lower) continue;
        if (right) {
            x = 63 - x;
            y = 63 - y;
        }
        const std::uint32_t old = x;
        x = y;
        y = old;
    }
    return index;
}

/// Interleaved gradient noise (Jimenez 2014, "Next Generation Post Processing in Call of Duty") in units of
/// 2^-32: each 3 x 3 pixels have nine values far apart.
constexpr std::uint32_t gradientNoise(std::uint32_t x, std::uint32_t y) {
    const std::uint32_t inner = x * 288237660U + y * 25070368U;               // of .06711056, .00583715
    return static_cast<std::uint32_t>(std::uint64_t{inner} * 3472289U >> 16); // of 52.9829189
}

/// The shift of the sample's pattern for `dimension` on the unit torus: v by gradient noise, u by the
/// golden ratio along Hilbert's curve, the samples of a pixel along the R2 sequence (Roberts 2018). Patterns
/// shifted so had the least error on average over 5 x 5 pixels (docs/shading.md).
constexpr SquarePoint evenShift(SampleId id, SampleDimension dimension, std::uint32_t salt = 0) {
    const std::uint32_t use = mixBits(static_cast<std::uint32_t>(dimension) << 24 | salt);
    const std::uint32_t u = hilbertIndex(id.x & 63U, id.y & 63U) * 2654435769U;
    const std::uint32_t v = gradientNoise(id.x, id.y);
    return {unitFloat(u + id.sub * 3242174889U + use), unitFloat(v + id.sub * 2447445414U + mixBits(use))};
}

} // namespace rtcore
