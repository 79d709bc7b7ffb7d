/// Views from all over a model, by which its light is learned before anyone walks through it.
#pragma once

#include "rtcore/accel/kd_tree.h"
#include "rtcore/scene/camera.h"
#include "rtcore/scene/mesh.h"
#include "rtcore/survey/survey.h"

#include <vector>

namespace rtcore {

/// To four sides, 90 degrees wide each, for square images, from the eyes of people who stand on the floors of
/// the subject, rows of a grid one after the other: so that views that follow each other show much of the
/// same. At most `maxStands` stands, spread evenly; none on roofs. Before them, where there are no rooms,
/// from around the subject and a little above. Some thousand rays. The same for the same model.
std::vector<Camera> walkGrid(const KdTree& tree, const Mesh& mesh, const Survey& survey, int maxStands = 120);

} // namespace rtcore
