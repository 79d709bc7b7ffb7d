/// Points that differ by rounding alone.
#pragma once

#include "rtcore/math/vec.h"
#include "rtcore/scene/disjoint_sets.h"

#include <cstdint>
#include <span>

namespace rtcore {

/// Sets of the points of some triangles (three indices each), of which those of `which`, each once, are one
/// but for rounding: all that lie within a millionth of the size of their part, in each coordinate, or within
/// what single precision can tell so far from the origin. Points up to twice as far apart may be one, too,
/// and those with others of `which` between them. A part is what triangles connect, where points of `which`
/// may be apart by a millionth of all together. Linear in time and memory: 12 bytes a point, 32 a part, and
/// up to 48 more for each of `which`. Positions must be finite.
DisjointSets weldPoints(std::span<const Vec3> points, std::span<const std::uint32_t> triangles,
                        std::span<const std::uint32_t> which);

} // namespace rtcore
