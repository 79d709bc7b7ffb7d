/// The points of waves whose glossy lobes are narrow: what they mirror is not light from all sides. Each
/// sends out rays along its lobe, which end where the radiance of surfaces is known (rtcore/gathering).
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/math/vec.h"
#include "rtcore/shading/surface/material_table.h"
#include "rtcore/shading/wave.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtcore {

struct LobeTap {
    Vec3 origin;              ///< just off the surface
    Vec3 direction;           ///< unit, off the face
    Colour factor;            ///< of the radiance that comes along it: the part that reaches the sample
    float width = 0;          ///< of the lobe, as a part of the ray's length: its standard deviation, about
    std::uint32_t sample = 0; ///< of the wave of primary rays
    std::uint32_t name = 0;   ///< of random numbers; that of each ray of a pixel is another
};

/// The part of what a point scatters that its lobe rays bring.
struct NarrowLobe {
    Colour albedo; ///< times the weight of the point; black: it sends out none
    float width = 0;
};

/// Of lobes wider than this in roughness there are none, and the whole lobe of those some narrower.
inline constexpr float kMaxLobeRoughness = 0.5F;

/// That of a point of a wave whose light has been divided. Parts below `minAlbedo` are left out.
NarrowLobe narrowLobeOf(const MaterialTable& materials, const SurfaceWave& surfaces, std::size_t point,
                        float minAlbedo);

/// Appends `rays` rays of the lobe at a point of the wave, which has one.
void addLobeTaps(const MaterialTable& materials, const Wave& wave, std::size_t point, const NarrowLobe& lobe,
                 std::uint32_t rays, std::vector<LobeTap>& taps);

} // namespace rtcore
