/// Cameras that see the point of a note.
#pragma once

#include "rtserver/document/document.h"

#include "rtcore/math/vec.h"
#include "rtcore/scene/camera.h"

#include <optional>

namespace rtserver {

/// The current camera, where the point lies within its image, hidden or not; else nothing.
std::optional<rtcore::Camera> viewOnto(const Document& document, const rtcore::Vec3d& point);

/// The current camera, moved and turned to the point: from where it is, or, where something stands too near
/// before the point, from the one of ten other sides with a long free way. A tenth of the model's
/// diagonal away at most; not beyond what stands there.
rtcore::Camera viewTowards(const Document& document, const rtcore::Vec3d& point);

} // namespace rtserver
