/// Sums of how much of the background samples see, in whole numbers: the same bits in any order, as
/// ImageSums.
#pragma once

#include "rtcore/scene/image.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtcore {

/// Different pixels may be added to by different threads at once.
class TransmittedSums {
  public:
    /// Those of no pixel where `pixels` is 0. Throws what std::vector throws.
    void start(std::size_t pixels) { sums_.assign(pixels, {}); }
    bool empty() const { return sums_.empty(); }

    /// A sample; one that is not finite counts as nothing seen.
    void add(std::size_t pixel, Colour part) {
        std::array<std::uint64_t, 3>& sum = sums_[pixel];
        sum[0] += units(part.r);
        sum[1] += units(part.g);
        sum[2] += units(part.b);
    }
    /// The mean of so many samples, each channel 0..1.
    Colour mean(std::size_t pixel, std::uint32_t samples) const {
        const auto channel = [&](std::size_t k) {
            const double sum = static_cast<double>(sums_[pixel][k]) / kUnit;
            return static_cast<float>(samples > 0 ? std::min(sum / samples, 1.0) : 0.0);
        };
        return {channel(0), channel(1), channel(2)};
    }

    static constexpr std::size_t kBytesPerPixel = 3 * sizeof(std::uint64_t);

  private:
    // 2^20 samples of 2^11 each, which paths through many panes may weigh, stay below 2^63.
    static constexpr double kUnit = 4294967296.0;
    static constexpr float kMaxPart = 2048;

    static std::uint64_t units(float part) {
        if (!(part > 0)) return 0;
        return static_cast<std::uint64_t>(static_cast<double>(std::min(part, kMaxPart)) * kUnit);
    }

    std::vector<std::array<std::uint64_t, 3>> sums_;
};

} // namespace rtcore
