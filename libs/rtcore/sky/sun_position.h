/// Where the sun stands.
#pragma once

#include "rtcore/math/vec.h"
#include "rtcore/scene/sky.h"

namespace rtcore {

/// Unit vector to the sun's middle as seen from the place: x to the east, y to the north, z up. Without
/// refraction, which lifts the sun by 0.5 degrees at the horizon and by less than 0.1 above 10 degrees.
/// Within 0.02 degrees from 1900 to 2100. The same bits on every processor. (Meeus, Astronomical Algorithms,
/// 2nd edition, chapters 12, 13 and 25.)
Vec3d sunFromPlace(const SunDate& date);

/// Unit vector to the sun in a scene whose up is one of the six axes.
Vec3 sunDirection(const Sky& sky, Vec3 up);

} // namespace rtcore
