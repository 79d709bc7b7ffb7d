/// The contributions of triangles to the normals of their corners.
#pragma once

#include "rtcore/scene/mesh.h"

#include <cstdint>
#include <span>

namespace rtcore {

/// Normal and corner angles of one triangle. Without initial values, so that a list of them costs nothing
/// until it is written.
struct Facet {
    float x, y, z;
    float angle[3];

    Vec3 normal() const { return {x, y, z}; }
    Vec3 weighted(std::uint32_t corner) const { return normal() * angle[corner]; }
};

/// `facets` has room for all triangles. The same bits with every instruction set. Safe from many threads.
void measureFacets(std::span<const Vertex> vertices, std::span<const Triangle> triangles, Facet* facets);
/// Their normals alone.
void measureNormals(std::span<const Vertex> vertices, std::span<const Triangle> triangles, Vec3* normals);

} // namespace rtcore
