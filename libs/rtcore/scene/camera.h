/// A pinhole camera with a flat (rectilinear) picture.
#pragma once

#include "rtcore/math/vec.h"

#include <cstdint>
#include <type_traits>

namespace rtcore {

struct Camera {
    Vec3 eye;                 ///< scene units
    Vec3 forward{0, 0, -1};   ///< need not be of unit length; not zero
    Vec3 up{0, 1, 0};         ///< need not be perpendicular to `forward`, only not parallel
    float horizontalFov = 60; ///< degrees between the left and right edge of the picture, 0 < fov < 180
    std::uint32_t nameOffset = 0;

    friend bool operator==(const Camera&, const Camera&) = default;
};
static_assert(std::is_trivially_copyable_v<Camera> && sizeof(Camera) == 44);

} // namespace rtcore
