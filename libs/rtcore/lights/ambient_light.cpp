#include "rtcore/lights/ambient_light.h"

#include "rtcore/math/constants.h"
#include "rtcore/scene/light_power.h"

#include <algorithm>

namespace rtcore {

namespace {

/// Distance of occlusion over the scene's diagonal.
constexpr float kUsualReach = 0.15F;
/// Ambient light over the light scattered by a surface that faces all lights: roughly what surrounding
/// surfaces send back.
constexpr float kFractionOfLights = 0.25F;

/// Irradiance from a light on a surface near the middle of the scene that faces it, as of a point light with
/// the same power.
Colour irradianceNear(const Light& light, Vec3 middle, float diagonal) {
    if (!traitsOf(light).position) return light.intensity;
    // A light close to the middle must not count as if it lit the whole scene that brightly.
    const float distance =
        std::max({length(light.position - middle), diagonal * 0.25F, light.radius, 1e-18F});
    return light.intensity / (distance * distance) * meanIntensity(light);
}

Colour lightOf(const Scene& scene, const Box3& bounds) {
    if (!isBlack(scene.ambient)) return scene.ambient;
    if (const Environment* const environment = scene.environment()) {
        const Colour mean = environment->meanRadiance();
        if (!isBlack(mean)) return mean;
    }
    if (!isBlack(scene.background)) return scene.background;
    const Vec3 middle = bounds.empty() ? Vec3{} : bounds.centre();
    Colour irradiance;
    for (const SceneLight& each : scene.lights) {
        if (each.light.on != 0) irradiance += irradianceNear(each.light, middle, bounds.diagonal());
    }
    return isBlack(irradiance) ? kWhite : irradiance * (kFractionOfLights / kPi);
}

} // namespace

OccludedLight occludedLight(const Scene& scene, const Box3& bounds,
                            const AmbientOcclusionSettings& settings) {
    const float distance = settings.distance > 0 ? settings.distance : kUsualReach * bounds.diagonal();
    return {settings.light > 0 ? kWhite * settings.light : lightOf(scene, bounds),
            std::max(distance, 1e-18F)};
}

} // namespace rtcore
