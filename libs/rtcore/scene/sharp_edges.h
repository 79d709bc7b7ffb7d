/// Edges that are seen as such.
#pragma once

#include "rtcore/scene/half_edges.h"

namespace rtcore {

/// Whether a surface ends at the edge whose sides these are, or bends there by more than 20 degrees.
/// `triangles`: their numbers in the mesh, by those of the list.
bool isSharp(const Mesh& mesh, std::span<const HalfEdge> sides, const Indices& triangles);

/// The unit normal by which the triangle winds, in double precision; zero for one without an area.
Vec3d exactNormal(const Mesh& mesh, std::uint32_t triangle);

} // namespace rtcore
