#include "rtcore/live/light_change.h"

#include "rtcore/lights/light_sample-inl.h"
#include "rtcore/math/colour.h"

#include <algorithm>
#include <cstddef>

namespace rtcore {

namespace {

/// On a surface at `position` that faces it.
float irradianceOf(const Light& light, Vec3 position) {
    return forKind(light.kind, [&]<LightKind kind>() {
        const Vec3 irradiance = HWY_NAMESPACE::sampleLight<kind, float>(light, position).irradiance;
        return luminance(Colour{irradiance.x, irradiance.y, irradiance.z});
    });
}

} // namespace

LightChange::LightChange(std::span<const Light> before, std::span<const Light> now) {
    for (std::size_t i = 0; i < std::max(before.size(), now.size()); ++i) {
        if (i < before.size() && i < now.size() && before[i] == now[i]) continue;
        if (i < before.size()) add(before[i]);
        if (i < now.size()) add(now[i]);
    }
}

void LightChange::add(const Light& light) {
    if (light.on == 0) return;
    changed_.push_back(light);
    everywhere_ = everywhere_ || isAreaLight(light);
}

bool LightChange::reaches(Vec3 position, float radiance) const {
    constexpr float kMin = 1e-3F;
    return everywhere_ || std::ranges::any_of(changed_, [&](const Light& light) {
               return irradianceOf(light, position) > kMin * radiance;
           });
}

} // namespace rtcore
