/// How much light a lamp sends to a point.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/math/vec.h"
#include "rtcore/scene/light.h"

#include <algorithm>
#include <limits>

namespace rtcore {

struct Illumination {
    Vec3 toLight;       ///< unit
    float distance = 0; ///< how far a shadow ray has to go: almost to the light, so that a lamp that lies in
                        ///< a ceiling shines whichever way its distance is rounded
    Colour irradiance;  ///< on a surface that faces the light, before shadows
};

/// 1 inside the inner cone of a spot, 0 outside the outer one, smoothstep of the cosine between.
inline float spotFactor(const Light& light, float cosine) {
    const float x = std::clamp((cosine - light.cosOuter) / (light.cosInner - light.cosOuter), 0.0F, 1.0F);
    return x * x * (3 - 2 * x);
}

/// A lamp with a size counts as a point in its middle.
inline Illumination illuminate(const Light& light, Vec3 position) {
    if (light.kind == LightKind::Directional) {
        return {-light.direction, std::numeric_limits<float>::max(), light.intensity};
    }
    const Vec3 offset = light.position - position;
    const float distance = length(offset);
    const Vec3 toLight = distance > 0 ? offset / distance : Vec3{0, 1, 0};
    const float counted = std::max(std::max(distance, light.radius), 1e-18F);
    Colour irradiance = light.intensity / (counted * counted);
    if (light.kind == LightKind::Spot)
        irradiance = irradiance * spotFactor(light, -dot(toLight, light.direction));
    if (light.kind == LightKind::Rectangle)
        irradiance = irradiance * std::max(-dot(toLight, light.direction), 0.0F);
    constexpr float kAlmost = 0.9999F;
    return {toLight, std::max(distance * kAlmost - light.radius, 0.0F), irradiance};
}

} // namespace rtcore
