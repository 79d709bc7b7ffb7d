/// A camera and a light for models that bring none.
#pragma once

#include "rtcore/accel/kd_tree.h"
#include "rtcore/scene/camera.h"
#include "rtcore/scene/light.h"
#include "rtcore/scene/mesh.h"

namespace rtcore {

/// Inside at eye height, looking along the longest view, when walls surround the middle of the model on all
/// sides; into it through the open side when it is a stage; else from the front and a little above, so that
/// all of it is in the image. `up` is a unit vector.
Camera defaultCamera(const KdTree& tree, const Mesh& mesh, Vec3 up);

/// Whether it would stand inside.
bool isInterior(const KdTree& tree, const Mesh& mesh, Vec3 up);

/// A point light above the viewer's right shoulder, of a strength that suits the size of the model.
Light defaultLight(const Camera& camera, const Box3& bounds);

} // namespace rtcore
