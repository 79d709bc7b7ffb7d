// The power of lights: light_power.h against the light that arrives on a sphere around each kind.
#include "rtcore/lights/ambient_light.h"
#include "rtcore/lights/light_direction-inl.h"
#include "rtcore/scene/light_power.h"
#include "rtcore/scene/scene.h"

#include "estimates.h"

#include <algorithm>
#include <string>

namespace rtcore {
namespace light_power {
namespace {

constexpr double kReach = 200; // so far away that any light is a point

/// One of each kind at the origin, none of them of the defaults.
std::vector<Light> lightsOfEachKind() {
    std::vector<Light> lights;
    for (std::size_t kind = 0; kind < kLightKinds; ++kind) {
        Light light = test::rectangleLight({}, 0.7F, 0.4F);
        light.kind = static_cast<LightKind>(kind);
        light.direction = normalize({1, -2, 0.5F});
        light.right = basisAround(light.direction).tangent;
        light.radius = traitsOf(light).radius ? 0.3F : 0;
        light.intensity = {2, 3, 5};
        lights.push_back(light);
    }
    lights[static_cast<std::size_t>(LightKind::Ies)].photometry =
        keepPhotometry({{0, 20, 40, 90, 120}, {0, 90, 270, 360}, {9, 5, 8, 1, 0, 9, 6, 2, 1, 0,
                                                                  9, 5, 4, 0, 0, 9, 5, 8, 1, 0}});
    Light spot = lights[static_cast<std::size_t>(LightKind::Spot)];
    for (const auto& [inner, outer] :
         {std::pair(0.9F, 0.3F), std::pair(0.2F, -0.6F), std::pair(0.99F, 0.98F)}) {
        spot.cosInner = inner;
        spot.cosOuter = outer;
        lights.push_back(spot);
    }
    return lights;
}

/// The irradiance of a surface at `position` that faces the light, in green.
double irradianceAt(const Light& light, Vec3 position) {
    constexpr int kSide = 4;
    double sum = 0;
    for (int i = 0; i < kSide * kSide; ++i) {
        const auto at = [](int k) { return (static_cast<float>(k) + 0.5F) / kSide; };
        sum += forKind(light.kind, [&]<LightKind kind>() {
            const auto sample = HWY_NAMESPACE::sampleLightDirection<kind, float>(
                light, position, at(i % kSide), at(i / kSide));
            return static_cast<double>(sample.irradiance.y);
        });
    }
    return sum / (kSide * kSide);
}

/// Watts of green that arrive on the sphere of kReach around it.
double arrivingPower(const Light& light) {
    constexpr int kHeights = 1500, kTurns = 16;
    const Basis side = basisAround(light.direction);
    double sum = 0;
    for (int i = 0; i < kHeights; ++i) {
        for (int k = 0; k < kTurns; ++k) {
            const double y = 2 * (i + 0.5) / kHeights - 1, turn = 2 * std::numbers::pi * k / kTurns;
            const double ring = std::sqrt(1 - y * y);
            const Vec3 direction = light.direction * static_cast<float>(y) +
                                   side.tangent * static_cast<float>(ring * std::cos(turn)) +
                                   side.bitangent * static_cast<float>(ring * std::sin(turn));
            sum += irradianceAt(light, direction * static_cast<float>(kReach));
        }
    }
    return sum * 4 * std::numbers::pi * kReach * kReach / (kHeights * kTurns);
}

std::string nameOf(const Light& light) { return std::string(traitsOf(light).name); }

TEST(LightPower, IsWhatArrivesOnASphereAroundTheLight) {
    for (const Light& light : lightsOfEachKind()) {
        if (!traitsOf(light).position) continue;
        const double power = static_cast<double>(powerFactor(light) * light.intensity.g);
        EXPECT_NEAR(arrivingPower(light) / power, 1, 2e-3) << nameOf(light) << ' ' << light.cosInner;
        EXPECT_NEAR(powerFactor<double>(light) / static_cast<double>(powerFactor(light)), 1, 1e-6);
        EXPECT_EQ(powerOf(light), luminance(light.intensity) * powerFactor(light));
    }
}

/// Nothing but the light lights the scene: its ambient light is that of a point light of the same power.
TEST(LightPower, GivesTheAmbientLightOfOcclusion) {
    Box3 bounds;
    bounds.extend(Vec3{-1, -1, -1});
    bounds.extend(Vec3{1, 1, 1});
    for (Light light : lightsOfEachKind()) {
        if (!traitsOf(light).position) continue;
        const double irradiance = arrivingPower(light) / (4 * std::numbers::pi * 100);
        light.position = {10, 0, 0};
        Scene scene;
        scene.lights = {light};
        EXPECT_NEAR(static_cast<double>(occludedLight(scene, bounds, {}).radiance.g),
                    irradiance / 4 / std::numbers::pi, 2e-3 * irradiance)
            << nameOf(light) << ' ' << light.cosInner;
    }
}

} // namespace
} // namespace light_power
} // namespace rtcore
