/// A triangle as the builders see it.
#pragma once

#include "rtcore/math/box.h"

#include <cstdint>

namespace rtcore {

/// A triangle of the mesh and the box of its part inside a node.
struct BoundedTriangle {
    Box3 box;
    std::uint32_t triangle = 0;
};

} // namespace rtcore
