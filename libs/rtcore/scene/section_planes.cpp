#include "rtcore/scene/section_planes.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

std::optional<Sentence> problemOf(const SectionPlane& plane) {
    constexpr float kFarthest = 1e12F;
    const Vec3 p = plane.point, n = plane.normal;
    if (!isFinite(n) || normalize(n) == Vec3{})
        return say("the normal of the section is zero or too large; give the side that is taken away");
    const auto beyond = [](float x) { return !(std::fabs(x) <= kFarthest); };
    if (beyond(p.x) || beyond(p.y) || beyond(p.z))
        return say("the point of the section has a coordinate beyond 1e12; give one near the model");
    return std::nullopt;
}

std::optional<SectionLight> sectionLightNamed(std::string_view name) {
    const auto* const at = std::ranges::find(kSectionLights, name);
    if (at == kSectionLights.end()) return std::nullopt;
    return static_cast<SectionLight>(at - kSectionLights.begin());
}

std::optional<CapColours> capColoursNamed(std::string_view name) {
    const auto* const at = std::ranges::find(kCapColours, name);
    if (at == kCapColours.end()) return std::nullopt;
    return static_cast<CapColours>(at - kCapColours.begin());
}

std::vector<SectionPlane> planesAround(Vec3 lo, Vec3 hi) {
    std::vector<SectionPlane> planes;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 normal;
        normal[axis] = 1;
        planes.push_back({hi, normal});
        planes.push_back({lo, Vec3{} - normal}); // no -0
    }
    return planes;
}

} // namespace rtcore
