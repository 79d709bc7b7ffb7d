#include "rtcore/post/exposure.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

namespace rtcore {

namespace {

/// Bins of a histogram over the bits of a positive float: 256 in each power of two.
constexpr unsigned kShift = 15;
constexpr std::size_t kBins = std::size_t{0x7F800000U} >> kShift;
constexpr double kDropped = 0.1; ///< share of the weight at each end

float middleOfBin(std::size_t bin) {
    return std::bit_cast<float>(static_cast<std::uint32_t>(bin << kShift | std::size_t{1} << (kShift - 1)));
}

} // namespace

std::optional<float> logAverageLuminance(std::span<const Colour> pixels,
                                         std::span<const std::uint8_t> weights) {
    std::vector<std::uint64_t> histogram(kBins);
    std::uint64_t valid = 0;
    std::uint64_t possible = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const float y = luminance(pixels[i]);
        possible += 255;
        if (!(y > 0) || !std::isfinite(y)) continue;
        histogram[std::bit_cast<std::uint32_t>(y) >> kShift] += weights[i];
        valid += weights[i];
    }
    if (valid == 0 || valid * 100 < possible) return std::nullopt;

    const double from = kDropped * static_cast<double>(valid);
    const double to = (1 - kDropped) * static_cast<double>(valid);
    double below = 0;
    double sum = 0;
    for (std::size_t bin = 0; bin < kBins; ++bin) {
        if (histogram[bin] == 0) continue;
        const double above = below + static_cast<double>(histogram[bin]);
        const double kept = std::min(above, to) - std::max(below, from);
        if (kept > 0) sum += kept * static_cast<double>(portableLog2(middleOfBin(bin)));
        below = above;
    }
    return portableExp2(static_cast<float>(sum / (to - from)));
}

} // namespace rtcore
