/// The eye of a walker, which follows the body without a jerk.
#pragma once

#include "rtcore/motion/walk_shape.h"
#include "rtcore/motion/walk_state.h"

#include <span>

namespace rtcore {

/// One tick. After a step the eye is drawn by a critically damped spring: below its position inside the body,
/// above it only as far as there is room among `triangles`.
void easeEye(const WalkShape& shape, std::span<const SolidTriangle> triangles, WalkState& state);

} // namespace rtcore
