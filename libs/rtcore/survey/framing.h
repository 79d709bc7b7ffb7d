/// Views that show a thing whole.
#pragma once

#include "rtcore/math/box.h"
#include "rtcore/scene/camera.h"
#include "rtcore/scene/mesh.h"

namespace rtcore {

/// `camera` with its direction, its field of view and what is up in it, from as near, or as wide, as shows
/// the vertices within the box whole in an image of that aspect, with equal margins on opposite sides, of 6 %
/// of it at least. A box without vertices is shown itself.
Camera framed(const Mesh& mesh, const Box3& box, Camera camera, float aspect);

} // namespace rtcore
