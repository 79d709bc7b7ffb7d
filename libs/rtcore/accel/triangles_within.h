/// The triangles of a model that planes cut open.
#pragma once

#include "rtcore/math/half_space.h"
#include "rtcore/scene/mesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// One value for each triangle: 1 where no part of it is within all of `halves`, moved outwards by `margin`,
/// else 0. Sutherland and Hodgman 1974, in double. All threads. Throws std::bad_alloc.
std::vector<std::uint8_t> trianglesBeyond(const Mesh& mesh, std::span<const HalfSpace> halves, float margin);

} // namespace rtcore
