/// The field of view, and the lens of a camera for film of 36 x 24 mm that has it: two names of one thing.
#pragma once

#include <cmath>
#include <numbers>

namespace rtcore {

inline constexpr double kFilmWidth = 36; ///< millimetres

/// For the angle between the left and right edge, in degrees, 0 < angle < 180: the edge's distance from the
/// middle, in distances from the eye.
inline double halfWidthOfAngle(double degrees) { return std::tan(degrees * std::numbers::pi / 360); }
inline double angleOfHalfWidth(double halfWidth) { return std::atan(halfWidth) * 360 / std::numbers::pi; }

/// Millimetres, above 0.
inline double focalLengthOfAngle(double degrees) { return kFilmWidth / 2 / halfWidthOfAngle(degrees); }
inline double angleOfFocalLength(double millimetres) {
    return angleOfHalfWidth(kFilmWidth / 2 / millimetres);
}

} // namespace rtcore
