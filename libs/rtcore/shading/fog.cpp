#include "rtcore/shading/fog.h"

#include "rtcore/shading/phong.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

/// (1 - e^-x) / x for x >= 0.
float meanDecay(float x) {
    if (x < 0.25F) {
        return 1 - x * (1.0F / 2 - x * (1.0F / 6 - x * (1.0F / 24 - x * (1.0F / 120 - x * (1.0F / 720)))));
    }
    return (1 - portableExp(-x)) / x;
}

Colour surroundingsOf(const Scene& scene) {
    const Environment* const environment = scene.environment();
    return scene.ambient + (environment != nullptr ? environment->meanRadiance() : scene.background);
}

} // namespace

float FogMedium::height(Vec3 position) const {
    return std::max((dot(up, position) - ground) * perHeight, kLowest);
}

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
    if (fog.surroundings > 0) medium.source += fog.surroundings * fog.albedo * surroundingsOf(scene);
    medium.scattered = fog.albedo / (4 * kPi);
    return medium;
}

float fogLength(const FogMedium& fog, Vec3 origin, Vec3 direction, float distance) {
    if (!fog.exponential) return distance;
    const float slope = dot(fog.up, direction) * fog.perHeight;
    const float from = fog.height(origin);
    const float to = std::max(from + slope * distance, FogMedium::kLowest);
    const float rise = std::fabs(slope) * distance;
    const float densest = portableExp(-std::min(from, to));
    // Of endless rays distance * meanDecay would be infinity * 0.
    if (rise > 16) return densest / std::fabs(slope);
    return densest * distance * meanDecay(rise);
}

float fogTransmittance(const FogMedium& fog, Vec3 origin, Vec3 direction, float distance) {
    return portableExp(-fog.density * fogLength(fog, origin, direction, distance));
}

float fogOpacity(const FogMedium& fog, Vec3 origin, Vec3 direction, float distance) {
    const float tau = fog.density * fogLength(fog, origin, direction, distance);
    return tau < 16 ? tau * meanDecay(tau) : 1.0F;
}

float fogLightTransmittance(const FogMedium& fog, const Light& light, Vec3 position) {
    if (light.kind == LightKind::Directional) {
        return fog.exponential ? fogTransmittance(fog, position, -light.direction, kEndless) : 1.0F;
    }
    const Vec3 offset = light.position - position;
    const float distance = length(offset);
    return distance > 0 ? fogTransmittance(fog, position, offset / distance, distance) : 1.0F;
}

} // namespace rtcore
