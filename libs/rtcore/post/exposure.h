/// Exposure that suits an image, as an eye would choose it.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/render/frame.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace rtcore {

/// How much weight pixels of each luminance have, 256 bins in each power of two. Integers, so that parts of
/// an image may be counted apart and added in any order; below 0 where a correction takes away what is not
/// there.
class LuminanceHistogram {
  public:
    /// Forgets all; keeps the memory, half a megabyte.
    void clear();
    /// Counts pixels, or luminances, > 0, each by its weight (255: geometry counts, 0: background does
    /// not); spans of one size. No weights: 255 each.
    void count(std::span<const Colour> pixels, std::span<const std::uint8_t> weights);
    void count(std::span<const Colour> pixels);
    void count(std::span<const float> luminances, std::span<const std::uint8_t> weights);
    void add(const LuminanceHistogram& other);
    /// Each of these pixels stands for `times` as many: as far as they are from what was kept of them, the
    /// others are, too. (control variates)
    void correct(std::span<const CheckedPixel> checked, std::int64_t times);

    /// The robust log-average luminance: without the darkest and brightest tenth. Nothing when the weight of
    /// the counted pixels is less than 1 % of what all given ones could have. The same bits for the same
    /// input.
    std::optional<float> logAverage() const;

  private:
    std::vector<std::int64_t> bins_; ///< the last one for what does not count
    std::int64_t possible_ = 0;
};

} // namespace rtcore
