/// The light of samples from afar: means over squares of pixels, for pixels that have no sample.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/render/pixel_area.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace rtcore {

/// Keeps its memory from frame to frame.
class SampleMeans {
  public:
    static constexpr int kSide = 64; ///< pixels of the largest squares: parts of an image are multiples of it

    void begin(int width, int height);
    /// Takes the rows of pixels from `first`, a multiple of kSide, to before `last`: that far away, or the
    /// end of the image; every second pixel of every second row, of those whose light, lightAt(x, y), is not
    /// below 0. Different rows may be taken by several threads at once.
    template <typename LightAt>
    void take(LightAt&& lightAt, int first, int last) {
        Level& finest = levels_[0];
        constexpr int kSquare = 1 << kStep;
        for (int row = first >> kStep; row * kSquare < last; ++row) {
            const int top = row * kSquare, bottom = std::min(top + kSquare, last);
            for (int column = 0; column < finest.columns; ++column) {
                const int left = column * kSquare, right = std::min(left + kSquare, width_);
                finest.at(column, row) = sumOf(lightAt, {left, top, right - left, bottom - top});
            }
        }
        for (std::size_t i = 1; i < levels_.size(); ++i) addUp(levels_[i - 1], levels_[i], first, last);
    }

    /// Around the pixel, of the smallest squares that have samples; black where there are none. All rows must
    /// have been taken.
    Colour around(int x, int y) const;

  private:
    static constexpr int kStep = 2; ///< a square has 2^kStep squares of the next finer level a side

    struct Sum {
        Colour light;
        float samples = 0;
    };
    struct Level {
        int shift = 0; ///< a square has 2^shift pixels a side
        int columns = 0, rows = 0;
        std::vector<Sum> sums;

        Sum& at(int column, int row) {
            return sums[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                        static_cast<std::size_t>(column)];
        }
        const Sum& at(int column, int row) const { return const_cast<Level*>(this)->at(column, row); }
        Sum around(int x, int y) const;
    };
    template <typename LightAt>
    static Sum sumOf(LightAt&& lightAt, const PixelArea& square) {
        constexpr int kEvery = 2;
        Sum sum;
        for (int y = square.top; y < square.top + square.rows; y += kEvery) {
            for (int x = square.left; x < square.left + square.columns; x += kEvery) {
                const Colour there = lightAt(x, y);
                if (there.r < 0) continue;
                sum.light += there;
                sum.samples += 1;
            }
        }
        return sum;
    }
    void addUp(const Level& fine, Level& coarse, int first, int last) const;

    int width_ = 0;
    std::array<Level, 3> levels_; ///< of 4, 16 and 64 pixels
};

} // namespace rtcore
