/// Lights without extent. The record is written to .bsp files as it stands here.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/math/vec.h"

#include <cstdint>
#include <type_traits>

namespace rtcore {

enum class LightKind : std::uint32_t { Point = 0, Directional = 1, Spot = 2 };

struct Light {
    LightKind kind = LightKind::Point;
    Vec3 position;             ///< point and spot: where it is, scene units
    Vec3 direction{0, -1, 0};  ///< directional and spot: where it shines to, unit length
    Colour intensity{1, 1, 1}; ///< point and spot: radiant intensity, W/sr (so irradiance is intensity /
                               ///< d^2); directional: irradiance on a surface that faces it, W/m^2
    float radius = 0;          ///< point and spot: distances below it count as it (no infinite brightness)
    float cosInner = 1;        ///< spot: cosine of the half-angle of full brightness
    float cosOuter = 0;        ///< spot: cosine of the half-angle at which it ends; < cosInner
    std::uint32_t on = 1;      ///< 0 or 1
    std::uint32_t nameOffset = 0;

    friend bool operator==(const Light&, const Light&) = default;
};
static_assert(std::is_trivially_copyable_v<Light> && sizeof(Light) == 60);

} // namespace rtcore
