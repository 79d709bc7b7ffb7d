/// Lights for a room whose model has none.
#pragma once

#include "rtcore/accel/kd_tree.h"
#include "rtcore/scene/light.h"
#include "rtcore/scene/mesh.h"
#include "rtcore/survey/survey.h"

#include <vector>

namespace rtcore {

inline constexpr int kMaxRoomLights = 4;

/// Spheres under the ceiling, above places from which the others are seen best, until one more would bring
/// little; none where there are no walls around, or no ceiling. On the floor below, and in the mean over the
/// places of a room that is not too long for them, the irradiance is about 1. (docs/shading.md) The same for
/// the same mesh; some ten thousand rays.
std::vector<Light> roomLights(const KdTree& tree, const Mesh& mesh, const Survey& survey);

} // namespace rtcore
