/// A triangle as the builders see it.
#pragma once

#include "rtcore/math/box.h"

#include <bit>
#include <cstdint>
#include <type_traits>

namespace rtcore {

/// A triangle of the mesh and the box of its part inside a node. Two aligned vectors, so that all axes are
/// computed at once; without initial values, so that lists of it cost nothing until they are written.
struct alignas(16) BoundedTriangle {
    float lo[4]; ///< the fourth: bits of the triangle's index, which below 2^30 are a positive number
    float hi[4]; ///< the fourth: 0

    Box3 box() const { return {{lo[0], lo[1], lo[2]}, {hi[0], hi[1], hi[2]}}; }
    std::uint32_t triangle() const { return std::bit_cast<std::uint32_t>(lo[3]); }
};
static_assert(sizeof(BoundedTriangle) == 32 && std::is_trivial_v<BoundedTriangle>);

} // namespace rtcore
