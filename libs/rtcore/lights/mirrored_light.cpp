#include "rtcore/lights/mirrored_light.h"

#include "rtcore/lights/light_hit-inl.h"

namespace rtcore {

std::optional<float> distanceToMirrored(const Light& light, Vec3 origin, Vec3 direction, float end) {
    const float distance = forKind(light.kind, [&]<LightKind kind>() {
        return HWY_NAMESPACE::hitLight<kind, float>(light, origin, direction);
    });
    return distance < end ? std::optional(distance) : std::nullopt;
}

Colour radianceOfMirrored(const Light& light) {
    return forKind(light.kind, [&]<LightKind kind>() -> Colour {
        if constexpr (isAreaLight(kind)) return HWY_NAMESPACE::radianceOf<kind>(light);
        return {};
    });
}

} // namespace rtcore
