/// A triangle as the builders see it.
#pragma once

#include "rtcore/math/box.h"

#include <cstdint>
#include <type_traits>

namespace rtcore {

/// A triangle of the mesh and the box of its part inside a node. Two aligned vectors, so that all axes are
/// computed at once; without initial values, so that lists of it cost nothing until they are written.
struct alignas(16) BoundedTriangle {
    float lo[3];
    std::uint32_t triangle;
    float hi[3];
    std::uint32_t zero; ///< makes the second vector one of four numbers

    static BoundedTriangle of(std::uint32_t triangle, const Box3& box) {
        return {{box.lo.x, box.lo.y, box.lo.z}, triangle, {box.hi.x, box.hi.y, box.hi.z}, 0};
    }
    Box3 box() const { return {{lo[0], lo[1], lo[2]}, {hi[0], hi[1], hi[2]}}; }
};
static_assert(sizeof(BoundedTriangle) == 32 && std::is_trivial_v<BoundedTriangle>);

} // namespace rtcore
