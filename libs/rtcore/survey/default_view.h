/// A camera and a light for models that bring none.
#pragma once

#include "rtcore/accel/kd_tree.h"
#include "rtcore/scene/camera.h"
#include "rtcore/scene/light.h"
#include "rtcore/scene/mesh.h"
#include "rtcore/survey/survey.h"

namespace rtcore {

/// In a room where a person fits, at a person's eye height, where one sees far and much, when there is more
/// to see inside than outside; into it through the open side when it is a stage; else from the front and a
/// little above, so that all that the model is about is in the image (subject.h).
Camera defaultCamera(const KdTree& tree, const Mesh& mesh, const Survey& survey);

/// From where an object is looked at, as seen from it: the front, a little of the right side, a little above.
/// Not of unit length.
Vec3 threeQuarters(const Axes& axes);

/// A point light above the viewer's right shoulder, of a strength that suits the size of the model.
Light defaultLight(const Camera& camera, const Box3& bounds);

} // namespace rtcore
