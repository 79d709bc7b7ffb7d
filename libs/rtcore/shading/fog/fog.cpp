#include "rtcore/shading/fog/fog.h"

#include "rtcore/math/constants.h"
#include "rtcore/shading/fog/fog_math-inl.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

/// The light of the sky stands for ambient light here, too.
Colour surroundingsOf(const Scene& scene, const RenderSettings& settings) {
    const Environment* const environment = scene.environment();
    const Colour ambient = settings.skyLight.on ? Colour{} : scene.ambient;
    return ambient + (environment != nullptr ? environment->meanRadiance() : scene.background);
}

} // namespace

FogMedium fogMedium(const Scene& scene, const RenderSettings& settings) {
    const Fog& fog = scene.fog;
    FogMedium medium;
    medium.on = settings.fog.on && fog.kind != FogKind::None && fog.density > 0;
    if (!medium.on) return medium;
    medium.exponential = fog.kind == FogKind::Exponential;
    medium.density = fog.density;
    medium.perHeight = medium.exponential ? 1 / fog.scaleHeight : 0;
    medium.up = scene.up;
    medium.ground = fog.groundHeight;
    medium.source = fog.colour + fog.emission / fog.density;
    if (fog.surroundings > 0)
        medium.source += fog.surroundings * fog.albedo * surroundingsOf(scene, settings);
    medium.scattered = fog.albedo / (4 * kPi);
    return medium;
}

float fogLength(const FogMedium& fog, Vec3 origin, Vec3 direction, float distance) {
    return HWY_NAMESPACE::fogLength<float>(fog.exponential, fog, origin, direction, distance);
}

float fogTransmittance(const FogMedium& fog, Vec3 origin, Vec3 direction, float distance) {
    return portableExp(-fog.density * fogLength(fog, origin, direction, distance));
}

float fogLightTransmittance(const FogMedium& fog, const Light& light, Vec3 position) {
    if (!traitsOf(light).position) {
        return fog.exponential ? fogTransmittance(fog, position, -light.direction, kEndless) : 1.0F;
    }
    const Vec3 offset = light.position - position;
    const float distance = length(offset);
    return distance > 0 ? fogTransmittance(fog, position, offset / distance, distance) : 1.0F;
}

} // namespace rtcore
