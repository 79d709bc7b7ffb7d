/// Areas, volumes and clearances of a model.
#pragma once

#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/scene/scene.h"
#include "rtcore/sections/closed_pieces.h"

#include <cstdint>
#include <optional>
#include <span>

namespace rtcore {

/// Of the face that the triangle belongs to, in square scene units: of all triangles of the model that lie in
/// its plane and hang together with it by corners. Hidden parts do not count. Takes time of all triangles.
double areaOfFace(const Scene& scene, std::uint32_t triangle);

/// What these parts (numbers in Model::parts) enclose, in cubic scene units: the sum of each, without its
/// hollows; what two of them overlap counts twice. Nothing where one of them is open.
std::optional<double> volumeOf(const Model& model, std::span<const std::uint32_t> parts,
                               ClosedPieces& pieces);

/// From a point on a surface to the first other one along its unit normal, or straight down (`direction`):
/// scene units. Nothing: none is there.
std::optional<double> clearanceFrom(const RayTracer& shown, Vec3 point, Vec3 direction);

} // namespace rtcore
