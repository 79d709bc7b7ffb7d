/// Shading normals for triangles that come without.
#pragma once

#include "rtcore/scene/model.h"

namespace rtcore {

/// Gives every corner whose normal is (0, 0, 0) the average, weighted by angle, of the normals of those
/// triangles around its vertex - among corners without a normal - that are within `creaseAngle` (degrees,
/// 0..180) of its own triangle's; 0: its own alone. All normals in `model` are of unit length or zero;
/// afterwards only those of triangles without area can be zero. One entry of `normals` (with its texture
/// coordinate and colour) serves all corners that use it where they agree; where a crease parts them, entries
/// are added. Where `normals` is empty, all are missing, and entries are vertices. At an angle of 0, without
/// any normals, texture coordinates, colours and alphas, the entries are those of triangles. Triangles must
/// have valid indices, and be fewer than 2^30. Linear time, about 100 bytes a triangle for its duration.
/// Weights: Thuermer and Wuethrich 1998, "Computing Vertex Normals from Polygonal Facets".
void computeMissingNormals(ModelBuffers& model, float creaseAngle);

} // namespace rtcore
