/// The light of samples from afar: means over squares of pixels, for pixels that have no sample.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/scene/image.h"

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
    /// end of the image; every second pixel of every second row, of those whose light is not below 0.
    /// Different rows may be taken by several threads at once.
    void take(const HdrImage& light, int first, int last);

    /// Around the pixel, of the smallest squares that have samples; black where there are none. All rows must
    /// have been taken.
    Colour around(int x, int y) const;

  private:
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
    void addUp(const Level& fine, Level& coarse, int first, int last) const;

    std::array<Level, 3> levels_; ///< of 4, 16 and 64 pixels
};

} // namespace rtcore
