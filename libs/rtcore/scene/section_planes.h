/// Planes that cut a scene open.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/math/vec.h"
#include "rtcore/platform/sentence.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace rtcore {

/// What lies on the side that the normal points to is taken away; the plane itself stays.
struct SectionPlane {
    Vec3 point;  ///< in scene units
    Vec3 normal; ///< of any length
    friend bool operator==(const SectionPlane&, const SectionPlane&) = default;
};

/// Why it cannot cut: its normal is zero or not finite, or its point has a coordinate beyond 1e12, where no
/// model is.
std::optional<Sentence> problemOf(const SectionPlane& plane);

/// What light knows of the cut. Whole: nothing, so that rooms keep their light: rays of the camera, and what
/// they mirror and refract, are clipped alone. Cut: all rays are, so that light falls in.
enum class SectionLight : std::uint8_t { Whole, Cut };
inline constexpr std::array<std::string_view, 2> kSectionLights{"whole", "cut"};
inline std::string_view nameOf(SectionLight light) {
    return kSectionLights.at(static_cast<std::size_t>(light));
}
/// Nothing where none is called so.
std::optional<SectionLight> sectionLightNamed(std::string_view name);

/// What closes solids that are cut: areas in the colour of each material, or all in one colour, or nothing.
enum class CapColours : std::uint8_t { Own, One, None };
inline constexpr std::array<std::string_view, 3> kCapColours{"own", "one", "none"};
inline std::string_view nameOf(CapColours colours) {
    return kCapColours.at(static_cast<std::size_t>(colours));
}
/// Nothing where none is called so.
std::optional<CapColours> capColoursNamed(std::string_view name);

struct CapStyle {
    CapColours colours = CapColours::Own;
    Colour colour{0.1F, 0.1F, 0.1F}; ///< of CapColours::One: linear, as a display shows it
    bool hatched = false;
    friend bool operator==(const CapStyle&, const CapStyle&) = default;
};

inline constexpr std::size_t kMaxSectionPlanes = 6;

/// What several planes leave is on the kept side of each: it is convex, so that a ray is in it along one
/// interval.
struct SectionPlanes {
    std::vector<SectionPlane> planes; ///< kMaxSectionPlanes at most
    SectionLight light = SectionLight::Whole;
    CapStyle caps;

    bool empty() const { return planes.empty(); }
    /// Whether light, too, passes where the model was taken away.
    bool letLightIn() const { return !empty() && light == SectionLight::Cut; }
    friend bool operator==(const SectionPlanes&, const SectionPlanes&) = default;
};

/// The six planes around a box whose outside is taken away; `lo` is below `hi` on each axis.
std::vector<SectionPlane> planesAround(Vec3 lo, Vec3 hi);

} // namespace rtcore
