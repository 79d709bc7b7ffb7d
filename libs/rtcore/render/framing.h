/// Views that show a thing whole.
#pragma once

#include "rtcore/math/box.h"
#include "rtcore/scene/camera.h"
#include "rtcore/scene/mesh.h"

namespace rtcore {

/// `camera` with its direction, its field of view and what is up in it, from so far, or as wide, that the
/// vertices within the box are in an image of that aspect, with a margin of 5 %. A box without vertices is
/// shown itself.
Camera framed(const Mesh& mesh, const Box3& box, Camera camera, float aspect);

} // namespace rtcore
