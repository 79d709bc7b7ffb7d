/// Two images of the same view, each of about half the samples of every pixel.
#pragma once

#include "rtcore/scene/image.h"

#include <bit>
#include <cstddef>
#include <cstdint>

namespace rtcore {

/// What the two differ in is noise, and what one of them shows knows nothing of the other's noise: by that
/// the error of an image is estimated without a reference.
struct SampleHalves {
    HdrImage first, second;     ///< means; both empty: none are kept
    float firstFraction = 0.5F; ///< of all samples, those of `first`
    std::uint32_t samples = 0;  ///< of each pixel, of both together

    bool empty() const { return first.empty(); }
    static constexpr std::size_t kBytesPerPixel = 2 * sizeof(Colour);
};

/// Whether the sample of that index belongs to the first half. Of each octave, the samples 2^k to
/// 2^(k + 1) - 1, the lower half does; of the first two samples, the first. Such runs of a low-discrepancy
/// sequence are nets, as whole octaves are; every other sample would be one of each finest pair of strata,
/// without order. After 2^n samples the halves are equal in number, else the first has up to twice as many.
constexpr bool inFirstHalf(std::uint32_t sample) {
    return sample == 0 || (sample > 1 && (sample & (std::bit_floor(sample) >> 1U)) == 0);
}

} // namespace rtcore
