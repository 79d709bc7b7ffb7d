/// Where a sun would show a model best.
#pragma once

#include "rtcore/accel/kd_tree.h"
#include "rtcore/math/vec.h"
#include "rtcore/scene/camera.h"
#include "rtcore/scene/mesh.h"
#include "rtcore/survey/survey.h"

namespace rtcore {

/// Unit vector to it. Indoors, where it shines through windows or an open roof, the one of 48 directions in
/// which it lights most of what the camera sees; else behind the viewer's left shoulder, 40 degrees high.
/// The same for the same input; some ten thousand rays.
Vec3 sunOfView(const KdTree& tree, const Mesh& mesh, const Survey& survey, const Camera& camera);

} // namespace rtcore
