/// A described sky as what a scene is lit by: an environment and a light.
#pragma once

#include "rtcore/scene/environment.h"
#include "rtcore/scene/light.h"
#include "rtcore/scene/sky.h"

#include <memory>
#include <optional>

namespace rtcore {

/// Radiance 1 stands for so many cd/m^2: a white wall in the sun then has a radiance of 1 to 2. Of sun and
/// sky alike, so that their ratio is that of nature.
inline constexpr float kLuminanceOfOne = 20'000;
/// Albedo of the ground below the horizon: that of stones and grass, or of dry sand where there is haze.
/// In a studio that of the floor, which the three lights make as bright as the walls.
constexpr float groundAlbedo(const Sky& sky) {
    constexpr float kStudio = 0.85F, kSand = 0.35F, kGrass = 0.2F;
    return sky.studio ? kStudio : sky.haze ? kSand : kGrass;
}
/// Width of the equirectangular map: 0.35 degrees a texel. Only the horizon is sharper than that, and twice
/// the width costs four times the time whenever the sun is moved.
inline constexpr int kSkyWidth = 1024;

/// Light::discSine of the sun, which is seen under 0.53 degrees.
inline constexpr float kSunSine = 0.0046251060F;

struct SkyLight {
    std::shared_ptr<const Environment> environment; ///< named "sky", without the sun's disc; or "studio"
    std::optional<Light> sun;                       ///< directional; black once it has set; a studio has none
};

/// The sun alone, of a sky that has one; a microsecond.
Light sunOfSky(const Sky& sky, Vec3 up);

/// In a scene whose up is one of the six axes. Some 0.05 s. The same bits on every processor.
SkyLight skyLightOf(const Sky& sky, Vec3 up);

} // namespace rtcore
