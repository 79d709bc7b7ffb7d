/// Lights with a place as mirrors and glass that bends show them (isMirrored()). Cameras do not see them: a
/// light may stand in the image. What lies in or behind one is seen through it, as it occludes nothing.
#pragma once

#include "rtcore/scene/light.h"

#include <optional>

namespace rtcore {

/// The distance at which a ray that was mirrored or bent meets the light's shining side before `end`; nothing
/// where it misses. `direction`: of unit length.
std::optional<float> distanceToMirrored(const Light& light, Vec3 origin, Vec3 direction, float end);

/// Radiance of the light as the ray sees it.
Colour radianceOfMirrored(const Light& light);

} // namespace rtcore
