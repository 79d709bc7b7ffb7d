/// Which transparent surfaces bound a solid: there rays are refracted on entering and leaving. All others are
/// thin walls, which let rays pass unbent.
#pragma once

#include "rtcore/scene/material.h"
#include "rtcore/scene/mesh.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace rtcore {

/// One value per triangle, immutable, shared by all copies of a scene. 1 where the triangle belongs to a part
/// of connected transparent triangles in which each edge joins exactly two of them, oppositely oriented.
/// Null when no material is transparent.
using ClosedSurfaces = std::shared_ptr<const std::vector<std::uint8_t>>;

/// Degenerate triangles count like others. Takes time and memory of the transparent triangles only.
ClosedSurfaces findClosedSurfaces(const Mesh& mesh, std::span<const Material> materials);

} // namespace rtcore
