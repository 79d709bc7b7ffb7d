/// Lamps, of no size or of some. The record is written to .bsp files as it stands here.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/math/vec.h"

#include <cstdint>
#include <type_traits>

namespace rtcore {

/// A sphere shines from its whole surface alike, a rectangle from its front with the cosine (Lambert). Lamps
/// of any kind are not seen themselves, neither directly nor in mirrors.
enum class LightKind : std::uint32_t { Point = 0, Directional = 1, Spot = 2, Sphere = 3, Rectangle = 4 };

struct Light {
    LightKind kind = LightKind::Point;
    Vec3 position;             ///< all but directional: where its middle is, scene units
    Vec3 direction{0, -1, 0};  ///< directional, spot, rectangle: where it shines to, unit length
    Colour intensity{1, 1, 1}; ///< directional: irradiance on a surface that faces it, W/m^2; else radiant
                               ///< intensity in W/sr (so irradiance is intensity / d^2), of a rectangle
                               ///< straight ahead
    float radius = 0;          ///< sphere: how big it is; else distances below it count as it (no infinite
                               ///< brightness)
    float cosInner = 1;        ///< spot: cosine of the half-angle of full brightness
    float cosOuter = 0;        ///< spot: cosine of the half-angle at which it ends; < cosInner
    std::uint32_t on = 1;      ///< 0 or 1
    std::uint32_t nameOffset = 0;
    Vec3 right;       ///< rectangle: along its width; unit length, perpendicular to `direction`
    float width = 0;  ///< rectangle: scene units
    float height = 0; ///< rectangle: perpendicular to `right`

    friend bool operator==(const Light&, const Light&) = default;
};
static_assert(std::is_trivially_copyable_v<Light> && sizeof(Light) == 80);

/// Whether its shadows are soft.
inline bool hasSize(const Light& light) {
    return light.kind == LightKind::Sphere || light.kind == LightKind::Rectangle;
}

} // namespace rtcore
