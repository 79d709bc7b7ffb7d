/// Means of samples over squares of pixels, for pixels that have no sample.
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
    struct Weighed {
        Colour light{}; ///< times its weight
        float weight = 0;
    };
    /// Adds the rows of pixels from `first`, a multiple of kSide, to before `last`: the next multiple, or the
    /// end of the image. lightAt(x, y) is Weighed, with a weight of 1 at most. Different rows may be taken by
    /// several threads at once.
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

    /// The mean around a pixel: over small squares as far as they are known, else over larger ones; black
    /// where nothing is known. All rows must have been taken.
    Colour around(int x, int y) const;

  private:
    static constexpr int kStep = 1; ///< a square has 2^kStep squares of the next finer level a side

    struct Level {
        int shift = 0; ///< a square has 2^shift pixels a side
        int columns = 0, rows = 0;
        std::vector<Weighed> sums;

        Weighed& at(int column, int row) {
            return sums[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                        static_cast<std::size_t>(column)];
        }
        const Weighed& at(int column, int row) const { return const_cast<Level*>(this)->at(column, row); }
        Weighed around(int x, int y) const;
    };
    template <typename LightAt>
    static Weighed sumOf(LightAt&& lightAt, const PixelArea& square) {
        Weighed sum;
        for (int y = square.top; y < square.top + square.rows; ++y) {
            for (int x = square.left; x < square.left + square.columns; ++x) add(sum, lightAt(x, y));
        }
        return sum;
    }
    static void add(Weighed& sum, const Weighed& other) {
        sum.light += other.light;
        sum.weight += other.weight;
    }
    void addUp(const Level& fine, Level& coarse, int first, int last) const;

    int width_ = 0;
    std::array<Level, 6> levels_; ///< of 2, 4, ... 64 pixels
};

} // namespace rtcore
