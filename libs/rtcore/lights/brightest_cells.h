/// How bright an environment is at most in each cell of the sphere.
#pragma once

#include "rtcore/scene/environment.h"

#include <vector>

namespace rtcore {

/// The largest luminance, without the intensity, of the texels whose middles lie in each cell of an unfolded
/// octahedron of side x side (math/octahedron-inl.h), row by row; of cells without one, what is seen in their
/// middle. Negative light counts by its size; 0 where the image is not a number.
/// Cells at the poles of a map, where its texels are narrower than cells, are looked at in many points. Some
/// 10 ns for each texel and 10^-7 s for each cell without one.
std::vector<float> brightestInCells(const Environment& environment, int side);

/// The largest of each cell and its 8 neighbours on the sphere.
std::vector<float> brightestAround(const std::vector<float>& cells, int side);

} // namespace rtcore
