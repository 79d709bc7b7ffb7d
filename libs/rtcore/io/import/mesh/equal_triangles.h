/// Triangles that are in a model many times.
#pragma once

#include "rtcore/scene/model.h"

#include <cstdint>

namespace rtcore {

/// Removes the third and every further triangle of the same corners in the same order, part and material, and
/// returns how many these were. Every ray meets the first of them, whose shading stays, so images keep
/// their bits. Two stay, since a surface of one could be closed where that of many is not
/// (closed_surfaces.h). Those whose corners begin elsewhere or run the other way round stay: their distances
/// are rounded otherwise, and the other side is seen. Normals must be complete. Keeps the order; `parts`
/// follow. Linear time but for vertices that three or more triangles begin with.
std::uint64_t removeEqualTriangles(ModelBuffers& model);

} // namespace rtcore
