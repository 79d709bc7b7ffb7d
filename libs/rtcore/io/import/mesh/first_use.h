/// Vertices in the order in which triangles come to them.
#pragma once

#include "rtcore/scene/mesh.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// Numbers the vertices that `triangles` name, all below `vertices`, in the order of the corners that name
/// them first, and gives the corners these numbers. Returns the vertices by their new numbers. By the threads
/// of OpenMP for many triangles; the result does not depend on them. At most 2^30 triangles.
std::vector<std::uint32_t> renumberByFirstUse(std::span<Triangle> triangles, std::size_t vertices);

} // namespace rtcore
