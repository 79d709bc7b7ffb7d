// The disc of a directional light in path tracing: each way of its light counts once, whatever finds it.
#include "path_support.h"

#include "rtcore/scene/metallic_roughness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace rtcore {
namespace disc_paths {
namespace {

constexpr Vec3 kEye{0, 0, 4}, kAhead{0, 0, -1};

/// A directional light of irradiance 1, seen under an angle in degrees.
Light discFrom(Vec3 to, double degrees) {
    Light light;
    light.kind = LightKind::Directional;
    light.direction = -normalize(to);
    light.discSine = static_cast<float>(std::sin(degrees * test::kPi / 360));
    return light;
}
double discRadiance(double degrees) {
    const double sine = std::sin(degrees * test::kPi / 360);
    return 1 / (test::kPi * sine * sine);
}

Material rough(float roughness, float metallic = 1) {
    Material m;
    setMetallicRoughness(m, kWhite * 0.8F, metallic, roughness);
    return m;
}

test::PathScene floorUnder(const Material& material, const Light& light, const Fog& fog = {}) {
    test::SceneBuilder b;
    b.square({0, 0, 0}, {0, 1, 0}, 50, b.material(material));
    b.scene.lights = {light};
    b.scene.fog = fog;
    return test::PathScene(b.finish());
}

/// The light of such a disc that lobes reflect; nothing else is around the floor.
double reflected(const Material& material, double degrees, const Fog& fog = {}) {
    return floorUnder(material, discFrom({0.5F, 1, 0}, degrees), fog)
        .see({-1, 2, 0}, normalize({1, -2, 0}), 100'000, test::bouncesAlone(0))
        .mean[0];
}

TEST(DiscPaths, LobesAndSamplesFindTheSame) {
    for (const auto& [material, name] :
         {std::pair{test::matte(0.5F), "matte"}, std::pair{rough(0.5F), "rough"},
          std::pair{rough(0.2F), "smooth"}, std::pair{rough(0.1F, 0), "plastic"}}) {
        for (const double degrees : {8.0, 40.0}) {
            const test::PathScene scene = floorUnder(material, discFrom({0.5F, 1, 0}, degrees));
            test::expectLight(scene, {-1, 2, 0}, normalize({1, -2, 0}), 40'000, test::bouncesAlone(0),
                              reflected(material, degrees), name, 0.004 * reflected(material, degrees));
        }
    }
}

TEST(DiscPaths, FogTakesTheSameFromBoth) {
    Fog fog;
    fog.density = 0.1F;
    fog.albedo = {};
    fog.colour = {};
    for (const FogKind kind : {FogKind::Homogeneous, FogKind::Exponential}) {
        fog.kind = kind;
        fog.scaleHeight = 3;
        const test::PathScene scene = floorUnder(rough(0.2F), discFrom({0.5F, 1, 0}, 20), fog);
        const double expected = reflected(rough(0.2F), 20, fog);
        test::expectLight(scene, {-1, 2, 0}, normalize({1, -2, 0}), 40'000, test::bouncesAlone(0), expected,
                          "fog", 0.005 * expected);
    }
}

/// Something in the plane z = 0, with discs before and behind it.
test::PathScene beforeAndBehind(const Material& material, double degrees) {
    test::SceneBuilder b;
    b.square({0, 0, 0}, {0, 0, 1}, 1, b.material(material));
    b.scene.lights = {discFrom({0, 0, 1}, degrees), discFrom({0, 0, -1}, degrees)};
    return test::PathScene(b.finish());
}

TEST(DiscPaths, MirrorsPanesAndEyesSeeAllOfIt) {
    const double disc = discRadiance(0.53);
    for (const bool caustics : {false, true}) {
        test::PathLimits limits;
        limits.caustics = caustics;
        test::expectLight(beforeAndBehind(test::mirror(0.5F), 0.53), kEye, kAhead, 64, limits, 0.5 * disc,
                          "mirror", 1e-4 * disc);
        test::expectLight(beforeAndBehind(test::glass(1), 0.53), kEye, kAhead, 64, limits, disc, "pane",
                          1e-4 * disc);
        test::expectLight(beforeAndBehind(test::glass(1), 0.53), kEye, {0, 0, 1}, 64, limits, disc, "eye",
                          1e-4 * disc);
        test::SceneBuilder b;
        b.box({-1, -1, -1}, {1, 1, 0}, b.material(test::glass()));
        b.scene.lights = {discFrom({0, 0, -1}, 0.53)};
        const double passes = 0.96 * 0.96;
        test::expectLight(test::PathScene(b.finish()), kEye, kAhead, 20'000, limits, passes * disc, "solid",
                          0.01 * disc);
    }
}

/// The mean over a cone around the mirrored direction is all that the mirror sends of the irradiance.
TEST(DiscPaths, AGlintHasTheEnergyOfTheSun) {
    const test::PathScene scene = beforeAndBehind(test::mirror(1), 0.53);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    const double cone = std::sin(0.6 * test::kPi / 180);
    const test::PathMean mean = scene.mean(100'000, {}, [&](std::uint32_t) {
        const double r = cone * std::sqrt(unit(random)), turn = 2 * test::kPi * unit(random);
        const Vec3 aside{static_cast<float>(r * std::cos(turn)), static_cast<float>(r * std::sin(turn)),
                         -static_cast<float>(std::sqrt(1 - r * r))};
        return std::pair(Vec3{0, 0, 1}, aside);
    });
    EXPECT_NEAR(mean.mean[0] * test::kPi * cone * cone, 1, 5 * mean.error[0] * test::kPi * cone * cone);
}

/// A floor beside a mirrored wall: what the wall throws down is a caustic.
TEST(DiscPaths, ByAMirrorToAMatteFloorItIsACaustic) {
    test::SceneBuilder b;
    b.square({0, 0, 0}, {0, 1, 0}, 50, b.material(test::matte(1)));
    b.square({-1, 0, 0}, {1, 0, 0}, 50, b.material(test::mirror(1)));
    b.scene.lights = {discFrom({1, 1, 0}, 40)};
    const test::PathScene scene(b.finish());
    const double once = std::cos(test::kPi / 4) / test::kPi;
    test::PathLimits limits = test::bouncesAlone(0);
    test::expectLight(scene, {0.5F, 1, 0}, {0, -1, 0}, 50'000, limits, once, "without");
    limits.caustics = true;
    test::expectLight(scene, {0.5F, 1, 0}, {0, -1, 0}, 100'000, limits, 2 * once, "with");
}

/// Light passes a closed block of glass straight on, or bent where caustics count, never both.
TEST(DiscPaths, ThroughGlassItCountsOnce) {
    test::SceneBuilder b;
    b.square({0, 0, 0}, {0, 1, 0}, 50, b.material(test::matte(1)));
    b.box({-40, 1, -40}, {40, 2, 40}, b.material(test::glass()));
    b.scene.lights = {discFrom({0, 1, 0}, 30)};
    const test::PathScene scene(b.finish());
    test::PathLimits limits = test::bouncesAlone(0);
    const test::PathMean straight = scene.see({0, 0.5F, 0}, {0, -1, 0}, 100'000, limits);
    EXPECT_NEAR(straight.mean[0], 0.96 * 0.96 / test::kPi, 0.005);
    limits.caustics = true;
    const test::PathMean bent = scene.see({0, 0.5F, 0}, {0, -1, 0}, 100'000, limits);
    EXPECT_NEAR(bent.mean[0], straight.mean[0], 5 * bent.error[0] + 0.005);
}

TEST(DiscPaths, ManyLightsShareAlike) {
    test::SceneBuilder b;
    b.square({0, 0, 0}, {0, 1, 0}, 50, b.material(rough(0.2F)));
    b.scene.lights.assign(40, discFrom({0.5F, 1, 0}, 20));
    for (rtcore::SceneLight& each : b.scene.lights) each.light.intensity = kWhite * 0.025F;
    const double expected = reflected(rough(0.2F), 20);
    test::expectLight(test::PathScene(b.finish()), {-1, 2, 0}, normalize({1, -2, 0}), 40'000,
                      test::bouncesAlone(0), expected, "forty", 0.006 * expected);
}

} // namespace
} // namespace disc_paths
} // namespace rtcore
