/// Which transparent surfaces bound a solid: there rays are refracted on entering and leaving. All others are
/// thin walls, which let rays pass unbent.
#pragma once

#include "rtcore/scene/material.h"
#include "rtcore/scene/mesh.h"
#include "rtcore/scene/model.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace rtcore {

/// One value per triangle, immutable, shared by all copies of a scene. 1 where the triangle belongs to a part
/// of connected transparent triangles in which each edge joins exactly two of them, oppositely oriented; or
/// to one of glass that does so, and encloses more than rounding, once those ends of its open edges are one
/// that differ by rounding alone (weld.h). Null when no material is transparent.
using ClosedSurfaces = std::shared_ptr<const std::vector<std::uint8_t>>;

/// By triangle of the list: 1 where it belongs to a piece of them, connected by edges, in which as many
/// triangles run along each edge as against it: two of one solid, four where solids touch. How often such a
/// piece winds around a point is a whole number. Degenerate ones count like others.
std::vector<std::uint8_t> inClosedPieces(const Mesh& mesh, std::span<const std::uint32_t> triangles);

/// Degenerate triangles count like others. Takes time of the transparent triangles only, but for glass that
/// is open also a word of memory for each vertex.
ClosedSurfaces findClosedSurfaces(const Mesh& mesh, std::span<const Material> materials);

/// Glass that bounds no solid.
struct OpenGlass {
    std::string_view part;     ///< the model's name of it, which must outlive this; may be ""
    std::size_t triangles = 0; ///< of glass that are open
    std::size_t openEdges = 0; ///< which do not join two of them, oppositely oriented
    friend bool operator==(const OpenGlass&, const OpenGlass&) = default;
};
/// Tells the glass that is open, too: by name, in the order of the model's parts; triangles outside of all
/// parts count as one without a name.
ClosedSurfaces findClosedSurfaces(const Model& model, std::span<const Material> materials,
                                  std::vector<OpenGlass>& open);

} // namespace rtcore
