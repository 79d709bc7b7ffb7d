/// Lights: their record, which is written to .bsp files as it stands here, and one row of traits for each
/// kind.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/math/vec.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

namespace rtcore {

/// A sphere shines from its whole surface alike, a rectangle from its front with the cosine (Lambert). Lights
/// are not seen themselves, neither directly nor in mirrors, but for directional ones that are as large as
/// the sun: their disc is, wherever nothing is before it. The numbers stand in files.
enum class LightKind : std::uint32_t {
    Point = 0,
    Directional = 1,
    Spot = 2,
    Sphere = 3,
    Rectangle = 4,
    Ies = 5, ///< of a luminaire, by its photometric file
    Last = Ies
};

struct Light {
    LightKind kind = LightKind::Point;
    Vec3 position;             ///< all but directional: where its middle is, scene units
    Vec3 direction{0, -1, 0};  ///< directional, spot, rectangle: where it shines to, unit length; of a
                               ///< luminaire the axis from which its angles are measured
    Colour intensity{1, 1, 1}; ///< directional: irradiance on a surface that faces it, W/m^2; else radiant
                               ///< intensity in W/sr (so irradiance is intensity / d^2), of a rectangle
                               ///< straight ahead, of a luminaire where it is brightest
    float radius = 0;          ///< sphere: how big it is; else distances below it count as it (no infinite
                               ///< brightness). Of all kinds, what is nearer to the position does not occlude
    float cosInner = 1;        ///< spot: cosine of the half-angle of full brightness
    float cosOuter = 0;        ///< spot: cosine of the half-angle at which it ends; < cosInner
    std::uint32_t on = 1;      ///< 0 or 1
    std::uint32_t nameOffset = 0;
    Vec3 right;       ///< rectangle: along its width; luminaire: where its half-plane C = 0 points; unit
                      ///< length, perpendicular to `direction`
    float width = 0;  ///< rectangle: scene units
    float height = 0; ///< rectangle: perpendicular to `right`
    /// directional: sine of half the angle under which its disc is seen, 0..1; 0: it has no size
    float discSine = 0;
    std::uint32_t mirrored = 0;   ///< sphere, rectangle: 1 where mirrors and bending glass show it, 0 or 1
    std::uint32_t photometry = 0; ///< luminaire: number of its distribution (photometry.h); 0: none

    friend bool operator==(const Light&, const Light&) = default;
};
static_assert(std::is_trivially_copyable_v<Light> && sizeof(Light) == 92);

/// How the radiant intensity depends on the direction: not at all, in a spot's cone, with the cosine, or as
/// it was measured.
enum class Beam : std::uint8_t { Even, Cone, Cosine, Measured };

/// The properties in which kinds of lights differ, wherever they are not sampled (lights/light_sample-inl.h).
/// The `radius` of a Light is that of a ball whatever they say.
struct LightTraits {
    std::string_view name; ///< in .scn files
    bool position;         ///< it has one; else it shines from endlessly far away
    bool direction;        ///< it has one
    Beam beam;
    bool radius; ///< it is as big as its radius, which it needs
    bool sides;  ///< it has a width and a height
    bool disc;   ///< it may be seen as a disc, endlessly far away

    /// Whether it can be turned about its direction, and so has a `right`.
    constexpr bool turns() const { return sides || beam == Beam::Measured; }
};

/// By LightKind.
inline constexpr std::array<LightTraits, 6> kLightTraits{{
    {"point", true, false, Beam::Even, false, false, false},
    {"directional", false, true, Beam::Even, false, false, true},
    {"spot", true, true, Beam::Cone, false, false, false},
    {"sphere", true, false, Beam::Even, true, false, false},
    {"rectangle", true, true, Beam::Cosine, false, true, false},
    {"ies", true, true, Beam::Measured, false, false, false},
}};
inline constexpr std::size_t kLightKinds = kLightTraits.size();
static_assert(static_cast<std::size_t>(LightKind::Last) + 1 == kLightKinds, "a row for each kind");

constexpr const LightTraits& traitsOf(LightKind kind) { return kLightTraits[static_cast<std::size_t>(kind)]; }
constexpr const LightTraits& traitsOf(const Light& light) { return traitsOf(light.kind); }

/// Whether it is a disc that is seen wherever a ray leaves the scene towards it, and not black.
inline bool isDisc(const Light& light) {
    return traitsOf(light).disc && light.discSine > 0 && !isBlack(light.intensity);
}
/// Whether all of the kind have a place and a size.
constexpr bool isAreaLight(LightKind kind) { return traitsOf(kind).radius || traitsOf(kind).sides; }
/// Whether it has a place, and rays that were mirrored or bent see its surface, which is not black.
inline bool isMirrored(const Light& light) {
    const bool area = traitsOf(light).radius ? light.radius > 0 : light.width > 0 && light.height > 0;
    return light.mirrored != 0 && isAreaLight(light.kind) && area && !isBlack(light.intensity);
}
/// Whether it has a size, so that its shadows are soft.
inline bool isAreaLight(const Light& light) { return isAreaLight(light.kind) || isDisc(light); }
/// Whether it is an area light that lies in a plane and shines from its front.
constexpr bool isFlatLight(LightKind kind) { return isAreaLight(kind) && traitsOf(kind).direction; }

/// Radius of the ball around the position in which nothing occludes the light, and below which distances
/// count as it.
constexpr float ballRadius(const Light& light) { return light.radius; }

/// Calls use.operator()<kind>() for the kind of a light; returns what it returns.
template <std::size_t first = 0, typename Use>
[[gnu::always_inline]] inline auto forKind(LightKind kind, Use&& use) {
    if constexpr (first + 1 < kLightKinds) {
        if (kind != static_cast<LightKind>(first)) return forKind<first + 1>(kind, use);
    }
    return use.template operator()<static_cast<LightKind>(first)>();
}

} // namespace rtcore
