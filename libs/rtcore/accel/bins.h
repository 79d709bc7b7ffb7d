/// Candidates of the fast builder: borders of bins that divide a node's cell evenly.
#pragma once

#include "rtcore/accel/bounded_triangle.h"
#include "rtcore/accel/cost_model.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace rtcore {

inline constexpr std::size_t kMaxBins = 64;

/// Where the triangles of a node begin and end along all axes, counted by bins.
class Bins {
  public:
    /// `bins` is 2..kMaxBins.
    Bins(const Box3& cell, std::size_t bins);

    void add(const BoundedTriangle* triangles, std::size_t count);
    /// Adds what another one of the same cell counted.
    void add(const Bins& other);

    /// The cheapest border of a bin, or end of all triangles: that cuts off empty space exactly. `triangles`
    /// is how many were added. The numbers of triangles in the split are not set.
    Split cheapest(const Box3& cell, std::uint32_t triangles, const CostModel& cost) const;

  private:
    Split cheapestAlong(int axis, const Box3& cell, std::uint32_t triangles, const CostModel& cost) const;

    std::size_t bins_;
    /// By axis; the fourth number is 0.
    alignas(16) std::array<float, 4> lo_{}, scale_{}, first_, last_;
    std::array<std::array<std::uint32_t, kMaxBins>, 3> starts_, ends_; ///< cleared up to bins_
};

} // namespace rtcore
