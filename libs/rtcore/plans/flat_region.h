/// Whether points in a plane are inside of loops.
#pragma once

#include "rtcore/sections/cut_plane.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtcore {

/// Immutable; safe from many threads.
class FlatRegion {
  public:
    FlatRegion() = default;
    /// By the even-odd rule.
    explicit FlatRegion(const std::vector<FlatLoop>& loops);

    bool contains(const FlatPoint& p) const;

  private:
    struct Edge {
        FlatPoint a, b;
    };
    std::size_t bandOf(double y) const;

    double low_ = 0, high_ = -1;           ///< of all loops, along the second axis
    std::vector<std::vector<Edge>> bands_; ///< of equal height: the edges that reach into each
};

} // namespace rtcore
