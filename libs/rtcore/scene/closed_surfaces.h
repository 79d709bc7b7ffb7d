/// Which transparent surfaces bound a solid: there rays are refracted on entering and leaving. All others are
/// thin walls, which let rays pass unbent.
#pragma once

#include "rtcore/scene/material.h"
#include "rtcore/scene/mesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// One value per triangle, or nothing when no material is transparent. 1 where the triangle belongs to a part
/// of connected transparent triangles in which each edge joins exactly two of them, oppositely oriented.
/// Degenerate triangles count like others. Takes time and memory of the transparent triangles only.
std::vector<std::uint8_t> findClosedSurfaces(const Mesh& mesh, std::span<const Material> materials);

} // namespace rtcore
