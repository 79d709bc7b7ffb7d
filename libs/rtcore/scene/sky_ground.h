/// The ground below a model under a sky: what takes its shadow. (docs/shading.md, "The first look")
#pragma once

#include "rtcore/math/box.h"
#include "rtcore/scene/material.h"
#include "rtcore/scene/model.h"

#include <cstdint>
#include <memory>
#include <optional>

namespace rtcore {

/// Far: it ends where a sky's own ground looks the same. Fades: around the model it fades into what is
/// behind it, without an edge.
enum class GroundEdge : std::uint8_t { Far, Fades };

/// A level square far wider than the model, a little below its lowest point, that is seen from above alone.
/// Not part of the model: no file of it, no list of its parts and materials and no kd-tree has it. Immutable.
struct SkyGround {
    Mesh mesh;         ///< the model's, with the triangles of the square behind its own
    Material material; ///< its number is behind those of the model
    GroundEdge edge = GroundEdge::Far;
    std::uint32_t cells = 1; ///< to a side, of two triangles each
    Vec3 up;                 ///< of unit length
    Vec3 corner;             ///< from which `right` and `front` reach to the two beside it
    Vec3 right, front;

    std::shared_ptr<const void> storage; ///< owns the mesh
};

/// Makes the ground of a model with triangles, in a scene with that axis up; it scatters `albedo` of the
/// light. Takes memory of its own: as much as the model's mesh without colours and coordinates of textures,
/// and for these where there are any.
std::shared_ptr<const SkyGround> makeGround(const Model& model, Vec3 up, Colour albedo,
                                            GroundEdge edge = GroundEdge::Far);

/// Where the ray from `origin` meets it from above: the distance in units of `direction`.
std::optional<float> distanceToGround(const SkyGround& ground, Vec3 origin, Vec3 direction);

/// Which of its triangles has the point, counted from 0, and how far towards the triangle's second and
/// third corner that lies. Nothing beside the square.
struct GroundPoint {
    std::uint32_t triangle = 0;
    float u = 0, v = 0;
};
std::optional<GroundPoint> pointOnGround(const SkyGround& ground, Vec3 position);

} // namespace rtcore
