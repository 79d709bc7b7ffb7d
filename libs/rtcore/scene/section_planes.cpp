#include "rtcore/scene/section_planes.h"

#include <algorithm>

namespace rtcore {

std::optional<SectionLight> sectionLightNamed(std::string_view name) {
    const auto* const at = std::ranges::find(kSectionLights, name);
    if (at == kSectionLights.end()) return std::nullopt;
    return static_cast<SectionLight>(at - kSectionLights.begin());
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
