/// A view that turns about a point, and goes towards it, as one turns a thing in one's hand: what is at the
/// point stays where it is in the image.
#pragma once

#include "rtcore/math/vec.h"
#include "rtcore/scene/camera.h"

namespace rtcore {

/// Radians by which the thing turns to the right and upwards, so the eye to the left and downwards. The view
/// is upright from then on, and stays a little off straight up and straight down. `up` is a unit vector.
Camera orbited(const Camera& camera, Vec3 up, Vec3 pivot, double right, double upwards);

/// So many times as near to the point; above 0. An orthographic view gets narrower.
Camera approached(const Camera& camera, Vec3 pivot, double factor);

/// The eye moves so far to the right and upwards in the image; scene units.
Camera shifted(const Camera& camera, double right, double upwards);

} // namespace rtcore
