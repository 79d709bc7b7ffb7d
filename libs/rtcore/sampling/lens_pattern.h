/// Where the samples of a pixel pass through a lens.
#pragma once

#include "rtcore/sampling/sample_id.h"

#include <vector>

namespace rtcore {

/// One of 0..count-1 for each `i` of them, in an order of its own for each `key` (Kensler 2013, "Correlated
/// Multi-Jittered Sampling"). count: 1 or more.
std::uint32_t permuted(std::uint32_t i, std::uint32_t count, std::uint32_t key);

/// n x n points of the unit square for each pixel, spread evenly, in an order of its own: which half of the
/// lens a sample passes tells nothing about its position in the pixel. The same in every frame.
class LensPattern {
  public:
    /// Comes before all else. n: 1..16.
    void prepare(int n);

    /// The part of the pattern that the samples of a pixel share.
    struct Pixel {
        std::uint32_t key;
        SquarePoint shift;
    };
    static Pixel pixel(std::uint16_t x, std::uint16_t y);
    SquarePoint at(const Pixel& pixel, std::uint32_t sub) const;
    SquarePoint at(SampleId id) const { return at(pixel(id.x, id.y), id.sub); }

  private:
    std::vector<SquarePoint> points_;
};

} // namespace rtcore
