/// Where one who walks begins, when the view is from outside.
#pragma once

#include "rtcore/accel/kd_tree.h"
#include "rtcore/scene/camera.h"
#include "rtcore/scene/mesh.h"
#include "rtcore/survey/survey.h"

#include <vector>

namespace rtcore {

/// Whether one who looks from there would fall if he were to walk: he is high above the floor, or above the
/// lowest point of the model where there is none, and not in a room.
bool hoversOutside(const KdTree& tree, const Mesh& mesh, const Survey& survey, Vec3 eye);

/// Whether the body of a person is too large beside the model to walk about it.
bool isTooSmallToWalk(const Survey& survey);

/// Views of a person who stands a few steps before the model, faces it, and looks level: before a door, if
/// one is open, of the side that `from` looks at or another one; else before the middle of that side, and of
/// the others. Places with a floor come first; where none has, but there is one below `from`,
/// that place does. On land without anything on it: where `from` looks. The best first; some may have no room
/// for a body. The eyes are at kEyeHeight over the floor, or over the lowest point of the model where there
/// is none. Some thousand rays.
std::vector<Camera> doorsteps(const KdTree& tree, const Mesh& mesh, const Survey& survey, const Camera& from);

} // namespace rtcore
