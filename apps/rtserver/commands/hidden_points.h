/// Points that something hides from the camera.
#pragma once

#include "rtserver/document/document.h"

#include "rtcore/math/vec.h"

#include <span>
#include <vector>

namespace rtserver {

/// Whether something that is seen stands between the camera and each of the points, which are in scene units
/// from the scene's zero: by one ray each, which ends a little before its point, so that the surface that it
/// lies on does not count. Points that are not in front of the camera are not hidden. What sections take
/// away, and hidden parts, hide nothing; glass does. `document` is ready.
std::vector<bool> hiddenFromCamera(const Document& document, std::span<const rtcore::Vec3d> points);

} // namespace rtserver
