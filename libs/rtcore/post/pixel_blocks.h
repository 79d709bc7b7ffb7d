/// Pixels of an image in blocks of 8 x 8, over which what is known of their errors is pooled.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace rtcore {

/// Pixels of an image without those beyond its borders, in blocks.
struct PixelBlocks {
    static constexpr int kSide = 8;
    int width, height;

    int columns() const { return (width + kSide - 1) / kSide; }
    int rows() const { return (height + kSide - 1) / kSide; }
    std::size_t pixel(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    /// use(pixel) with each of the block, in their order.
    template <typename Use>
    void forEach(int column, int row, Use&& use) const {
        for (int y = row * kSide; y < std::min((row + 1) * kSide, height); ++y) {
            for (int x = column * kSide; x < std::min((column + 1) * kSide, width); ++x) use(x, y);
        }
    }
};

/// The two blocks whose middles are nearest on a line, and how much the second one counts.
class NearBlocks {
  public:
    struct Part {
        int block;
        double times;
    };

    NearBlocks(int position, int blocks) {
        const double at = (position + 0.5) / PixelBlocks::kSide - 0.5;
        const int below = static_cast<int>(std::floor(at));
        parts_ = {{{std::clamp(below, 0, blocks - 1), 1 - (at - below)},
                   {std::clamp(below + 1, 0, blocks - 1), at - below}}};
    }
    const std::array<Part, 2>& both() const { return parts_; }

  private:
    std::array<Part, 2> parts_;
};

} // namespace rtcore
