/// An order of points in which those that lie together follow each other.
#pragma once

#include "rtcore/irradiance/irradiance_record.h"
#include "rtcore/math/box.h"
#include "rtcore/math/vec.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// 10 bits of each coordinate in turns. (Morton 1966)
std::uint32_t alongCurve(Vec3 point, const Box3& bounds);

/// Keeps its memory.
class CurveOrder {
  public:
    /// The numbers of the receivers along the curve; in their order where they are in one cell of it.
    std::span<const std::uint32_t> of(std::span<const Receiver> receivers, const Box3& bounds);
    std::span<const std::uint32_t> last() const { return order_; } ///< what of() returned last

  private:
    struct Entry {
        std::uint32_t code, number;
    };
    std::vector<Entry> entries_, sorted_;
    std::vector<std::uint32_t> order_;
};

} // namespace rtcore
