// Without bounces, paths have the direct light of Whitted's ray tracing; and area lights their closed forms.

#include "path_support.h"

#include "support/steps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace rtcore {
namespace {

/// Surfaces of many lobes, one shadow on another.
Scene lobedScene() {
    test::SceneBuilder b;
    const auto phong = [&](float diffuse, float specular, float shininess) {
        Material m = test::matte(diffuse);
        m.specular = {specular, 0.5F * specular, specular};
        m.shininess = shininess;
        return b.material(m);
    };
    b.square({0, 0, 0}, {0, 1, 0}, 4, phong(0.5F, 0.4F, 20));
    b.sphere({-1, 1, 0}, 0.8F, 16, phong(0.2F, 0.7F, 300));
    b.sphere({1, 0.8F, 0.5F}, 0.7F, 16, phong(0.3F, 0.6F, 0.4F));
    b.box({-0.4F, 0, 1}, {0.4F, 0.7F, 1.6F}, phong(0.8F, 0, 1));
    return b.finish();
}

Light spotAbove() {
    Light light = test::pointLight({0.5F, 5, 2}, 60);
    light.kind = LightKind::Spot;
    light.direction = normalize({0, -1, -0.3F});
    light.cosInner = 0.97F;
    light.cosOuter = 0.8F;
    return light;
}

Light sunBeside() {
    Light light;
    light.kind = LightKind::Directional;
    light.direction = normalize({-1, -2, -0.5F});
    light.intensity = {3, 2, 1};
    return light;
}

/// Rays from one eye to a grid of places.
template <typename Use>
void forEachRay(Use&& use) {
    const Vec3 eye{0.3F, 2.5F, 6};
    for (const float y : test::steps(-1.0F, 2.0F, 0.11F)) {
        for (const float x : test::steps(-2.5F, 2.5F, 0.13F)) use(eye, normalize(Vec3{x, y, 0} - eye));
    }
}

TEST(DirectLight, OfLightsWithoutSizeIsThatOfWhitted) {
    for (const Light& light : {test::pointLight({2, 3, 2}, 30), spotAbove(), sunBeside()}) {
        Scene lit = lobedScene();
        lit.lights = {light};
        const test::PathScene scene(std::move(lit));
        RayWave rays;
        std::vector<SampleId> ids;
        forEachRay([&](Vec3 eye, Vec3 direction) {
            rays.push({eye, 0, direction, std::numeric_limits<float>::max()});
            ids.push_back({static_cast<std::uint16_t>(ids.size()), 0, 0});
        });
        const std::vector<Colour> seen = scene.trace(rays, ids, test::bouncesAlone(0));
        std::size_t lightened = 0;
        for (std::size_t i = 0; i < seen.size(); ++i) {
            const Ray ray = rays.ray(i);
            const Colour whitted = scene.traced.trace(ray.origin, ray.direction).radiance;
            EXPECT_NEAR(seen[i].r, whitted.r, 1e-5 * whitted.r + 1e-7) << i;
            EXPECT_NEAR(seen[i].g, whitted.g, 1e-5 * whitted.g + 1e-7) << i;
            lightened += whitted.r > 0 ? 1 : 0;
        }
        EXPECT_GT(lightened, seen.size() / 4);
    }
}

TEST(DirectLight, OfManyLightsIsTheirSumInTheMean) {
    for (const bool many : {false, true}) {
        Scene lit = lobedScene();
        lit.lights = {test::pointLight({2, 3, 2}, 30), spotAbove(), sunBeside(),
                      test::pointLight({-3, 0.5F, 1}, 2)};
        // More than are weighed one by one: they are chosen by their tree.
        for (int i = 0; many && i < 40; ++i) {
            const auto at = static_cast<float>(i);
            lit.lights.push_back(test::pointLight({0.2F * at - 4, 2 + 0.05F * at, -1}, 0.5F));
        }
        const test::PathScene scene(std::move(lit));
        for (const Vec3 to : {Vec3{0, 0, 2}, Vec3{-1, 1, 0}, Vec3{1, 1, 0.5F}}) {
            const Vec3 eye{0.3F, 2.5F, 6};
            const Colour whitted = scene.traced.trace(eye, to - eye).radiance;
            const auto seen = scene.see(eye, to - eye, 20000, test::bouncesAlone(0));
            EXPECT_GT(whitted.r, 0);
            EXPECT_NEAR(seen.mean[0], whitted.r, 5 * seen.error[0] + 1e-6) << many;
            EXPECT_NEAR(seen.mean[2], whitted.b, 5 * seen.error[2] + 1e-6) << many;
        }
    }
}

// Scattered rays meet those that are near, next event samples all: whatever finds them, nothing counts twice.
TEST(DirectLight, OfManyBallsNearAndFarIsTheSameByEachStrategy) {
    Scene lit = lobedScene();
    for (int i = 0; i < 40; ++i) {
        const auto at = static_cast<float>(i);
        Light ball = test::pointLight({0.2F * at - 4, 1 + 0.08F * at, 2 - 0.1F * at}, 0.5F);
        ball.kind = LightKind::Sphere;
        ball.radius = i % 2 == 0 ? 0.04F : 0.15F; // within their reach are some of the smaller ones
        lit.lights.push_back(ball);
    }
    const test::PathScene scene(std::move(lit));
    for (const Vec3 to : {Vec3{0, 0, 2}, Vec3{-1, 1, 0}, Vec3{1, 1, 0.5F}}) {
        const Vec3 eye{0.3F, 2.5F, 6};
        test::PathLimits limits = test::bouncesAlone(0);
        limits.strategy = SamplingStrategy::NextEvent;
        const auto expected = scene.see(eye, to - eye, 40000, limits);
        EXPECT_GT(expected.mean[0], 0);
        for (const SamplingStrategy strategy : {SamplingStrategy::Both, SamplingStrategy::ScatteredRays}) {
            limits.strategy = strategy;
            const auto seen = scene.see(eye, to - eye, 40000, limits);
            EXPECT_NEAR(seen.mean[0], expected.mean[0], 5 * std::hypot(seen.error[0], expected.error[0]))
                << static_cast<int>(strategy);
        }
    }
}

TEST(DirectLight, OfManyLightsSurvivesIntensitiesThatAreNoNumbers) {
    Scene lit = lobedScene();
    for (int i = 0; i < 40; ++i) lit.lights.push_back(test::pointLight({0, 3, 2}, 30));
    for (const float odd : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()})
        lit.lights.push_back(test::pointLight({2, 3, 2}, odd));
    const test::PathScene scene(std::move(lit));
    RayWave rays;
    std::vector<SampleId> ids;
    forEachRay([&](Vec3 eye, Vec3 direction) {
        rays.push({eye, 0, direction, std::numeric_limits<float>::max()});
        ids.push_back({static_cast<std::uint16_t>(ids.size()), 0, 0});
    });
    std::size_t lightened = 0;
    for (const Colour seen : scene.trace(rays, ids, test::bouncesAlone(0)))
        lightened += std::isfinite(seen.g) && seen.g > 0 ? 1 : 0;
    EXPECT_GT(lightened, ids.size() / 4);
}

/// The same light on the mean of each strategy.
void expectOneLight(const test::PathScene& scene) {
    const Vec3 eye{0.3F, 2.5F, 6};
    for (const Vec3 to : {Vec3{0, 0, 2}, Vec3{-1, 1, 0}}) {
        test::PathLimits limits = test::bouncesAlone(0);
        const test::PathMean both = scene.see(eye, to - eye, 20000, limits);
        EXPECT_GT(both.mean[0], 0.1);
        for (const SamplingStrategy strategy :
             {SamplingStrategy::NextEvent, SamplingStrategy::ScatteredRays}) {
            limits.strategy = strategy;
            const test::PathMean seen = scene.see(eye, to - eye, 20000, limits);
            EXPECT_NEAR(seen.mean[0], both.mean[0], 4 * (seen.error[0] + both.error[0]));
        }
    }
}

/// So many places around and above the scene.
Vec3 placeAround(int i) {
    const auto at = static_cast<float>(i);
    return {0.15F * at - 4, 1.5F + 0.5F * std::sin(at), 2 * std::cos(at)};
}

TEST(DirectLight, OfManyBallsIsTheSameByEitherStrategy) {
    Scene lit = lobedScene();
    for (int i = 0; i < 60; ++i) {
        Light ball = test::pointLight(placeAround(i), 0.5F);
        ball.kind = LightKind::Sphere;
        ball.radius = 0.3F;
        lit.lights.push_back(ball);
    }
    expectOneLight(test::PathScene(std::move(lit)));
}

TEST(DirectLight, OfManyEmissiveTrianglesIsTheSameByEitherStrategy) {
    // One to a cluster, and several, beside many lights.
    for (const int facets : {0, 32}) {
        test::SceneBuilder b;
        b.square({0, 0, 0}, {0, 1, 0}, 4, b.material(test::matte(0.6F)));
        const std::uint32_t shines = b.material(test::emitter({40, 30, 20}));
        for (int i = 0; i < 60; ++i) {
            if (facets == 0) {
                b.square(placeAround(i), normalize(Vec3{std::sin(static_cast<float>(i)), -1, 0.2F}), 0.2F,
                         shines);
            } else if (i % 5 == 0) {
                b.sphere(placeAround(i), 0.3F, facets, shines);
            }
        }
        Scene lit = b.finish();
        for (int i = 0; facets != 0 && i < 40; ++i)
            lit.lights.push_back(test::pointLight(placeAround(i), 0.1F));
        expectOneLight(test::PathScene(std::move(lit)));
    }
}

TEST(DirectLight, ThroughMirrorsPanesAndHolesIsThatOfWhittedInTheMean) {
    test::SceneBuilder b;
    Material half = test::mirror(0.4F);
    half.diffuse = {0.3F, 0.4F, 0.5F};
    half.fresnel = 1;
    Material pane = test::glass();
    pane.opacity = 0.3F;
    pane.diffuse = {0.6F, 0.2F, 0.2F};
    pane.transmission = {0.9F, 0.7F, 0.5F};
    Material leaf = test::matte(0.5F);
    leaf.alphaTexture = b.texture(2, 1, {{80, 0, 0, 255}, {200, 0, 0, 255}});
    b.square({0, 0, 0}, {0, 1, 0}, 4, b.material(half));
    b.square({0, 2, -2}, {0, 0, 1}, 3, b.material(test::matte(0.7F)));
    b.square({0.5F, 1, 1}, {0, 0, 1}, 0.8F, b.material(pane));
    b.square({-1, 1, 1}, {0, 0, 1}, 0.6F, b.material(leaf));
    b.sphere({0.6F, 0.7F, -0.5F}, 0.5F, 12, b.material(test::glass()));
    b.scene.lights = {test::pointLight({2, 3, 3}, 30)};
    b.scene.background = {0.2F, 0.3F, 0.5F};
    const test::PathScene scene(b.finish());
    const Vec3 eye{0.2F, 1.6F, 6};
    for (const Vec3 to : {Vec3{0.4F, 1.2F, 1}, Vec3{-1.1F, 1, 1}, Vec3{-0.8F, 1.1F, 1}, Vec3{0, 0, 2},
                          Vec3{0.6F, 0.7F, -0.5F}}) {
        // No light but that of the light and the background that is seen: a matte point alone is lit by it,
        // too.
        Scene dark = scene.traced.scene;
        const Colour whitted = scene.traced.trace(eye, to - eye, test::exactSettings(12)).radiance;
        test::PathLimits limits = test::bouncesAlone(0);
        RenderSettings settings = test::exactSettings(12);
        Scene plain = dark;
        plain.background = {};
        const test::PathScene unlit(std::move(plain), settings);
        const Colour expected = unlit.traced.trace(eye, to - eye, settings).radiance;
        const auto seen = unlit.see(eye, to - eye, 40000, limits);
        EXPECT_GT(expected.r, 0.001F);
        EXPECT_GT(whitted.r, expected.r - 1e-6F);
        EXPECT_NEAR(seen.mean[0], expected.r, 5 * seen.error[0] + 1e-5) << to.x;
        EXPECT_NEAR(seen.mean[2], expected.b, 5 * seen.error[2] + 1e-5) << to.x;
    }
}

/// The irradiance over pi times the radiance of a light, at the origin of a white floor.
void expectFormFactor(const test::PathScene& scene, double expected, const std::string& what) {
    for (const SamplingStrategy strategy :
         {SamplingStrategy::Both, SamplingStrategy::NextEvent, SamplingStrategy::ScatteredRays}) {
        test::PathLimits limits = test::bouncesAlone(0);
        limits.strategy = strategy;
        const auto seen = scene.see({0, 0.01F, 0}, {0, -1, 0}, 32768, limits);
        EXPECT_NEAR(seen.mean[0], expected, 5 * seen.error[0] + 1e-5) << what << static_cast<int>(strategy);
    }
}

TEST(AreaLight, RectangleHasItsClosedForm) {
    for (const auto& [height, expected] : std::array<std::pair<float, double>, 4>{
             {{0.1F, .968340}, {0.5F, .554126}, {1, .239456}, {2, .073478}}}) {
        test::SceneBuilder b;
        b.square({0, 0, 0}, {0, 1, 0}, 4, b.material(test::matte(1)));
        Light light;
        light.kind = LightKind::Rectangle;
        light.position = {0, height, 0};
        light.direction = {0, -1, 0};
        light.right = {1, 0, 0};
        light.width = light.height = 1;
        light.intensity = kWhite;
        b.scene.lights = {light};
        expectFormFactor(test::PathScene(b.finish()), expected, "rectangle at " + std::to_string(height));
    }
}

TEST(AreaLight, EmissiveRectangleHasTheSame) {
    for (const auto& [height, expected] :
         std::array<std::pair<float, double>, 3>{{{0.5F, .554126}, {1, .239456}, {2, .073478}}}) {
        test::SceneBuilder b;
        b.square({0, 0, 0}, {0, 1, 0}, 4, b.material(test::matte(1)));
        b.quad({-.5F, height, -.5F}, {.5F, height, -.5F}, {.5F, height, .5F}, {-.5F, height, .5F},
               b.material(test::emitter({1, 1, 1})));
        expectFormFactor(test::PathScene(b.finish()), expected, "emitter at " + std::to_string(height));
    }
}

TEST(AreaLight, PointsInsideOfASphereGetTheSameByAllStrategies) {
    // Next event samples the half of all directions that looks towards the middle.
    for (const float height : {-0.1F, 0.05F, 0.2F}) {
        test::SceneBuilder b;
        b.square({0, 0, 0}, {0, 1, 0}, 4, b.material(test::matte(0.5F)));
        Scene lit = b.finish();
        Light light = test::pointLight({0.05F, height, 0}, 1);
        light.kind = LightKind::Sphere;
        light.radius = 0.3F;
        lit.lights = {light};
        const test::PathScene scene(std::move(lit));
        test::PathLimits limits = test::bouncesAlone(0);
        limits.strategy = SamplingStrategy::NextEvent;
        const test::PathMean byLight = scene.see({0.01F, 1, 0.02F}, {0, -1, 0}, 40000, limits);
        test::expectLight(scene, {0.01F, 1, 0.02F}, {0, -1, 0}, 40000, limits, byLight.mean[0],
                          "height " + std::to_string(height), 5 * byLight.error[0]);
    }
}

TEST(AreaLight, SphereHasItsClosedFormAboveAndBelowTheHorizon) {
    struct Case {
        double sine, degrees, expected;
    };
    for (const Case& c : {Case{.5, 60, .125},
                          {.5, 80, .054696},
                          {.5, 90, .028834},
                          {.5, 100, .011284},
                          {.9, 0, .81},
                          {.9, 80, .305680},
                          {.9, 100, .165025},
                          {.2, 80, .006958}}) {
        test::SceneBuilder b;
        b.square({0, 0, 0}, {0, 1, 0}, 0.2F, b.material(test::matte(1)));
        Light light = test::pointLight(test::atAngle(c.degrees) * 2, 1);
        light.kind = LightKind::Sphere;
        light.radius = static_cast<float>(2 * c.sine);
        light.intensity = kWhite * (static_cast<float>(test::kPi) * light.radius * light.radius);
        b.scene.lights = {light};
        RenderSettings open = test::exactSettings();
        expectFormFactor(test::PathScene(b.finish(), open), c.expected,
                         "sphere " + std::to_string(c.sine) + " at " + std::to_string(c.degrees) + ": ");
    }
}

TEST(Surroundings, LightAFloorAsTheirIntegral) {
    test::SceneBuilder b;
    b.square({0, 0, 0}, {0, 1, 0}, 1, b.material(test::matte(0.6F)));
    b.scene.background = {1, 2, 3};
    const test::PathScene scene(b.finish());
    for (const SamplingStrategy strategy :
         {SamplingStrategy::Both, SamplingStrategy::NextEvent, SamplingStrategy::ScatteredRays}) {
        test::PathLimits limits = test::bouncesAlone(0);
        limits.strategy = strategy;
        const auto seen = scene.see({0, 1, 0}, {0.1F, -1, 0}, 16384, limits);
        EXPECT_NEAR(seen.mean[0], 0.6, 5 * seen.error[0] + 1e-5);
        EXPECT_NEAR(seen.mean[2], 1.8, 5 * seen.error[2] + 3e-5);
    }
}

TEST(Surroundings, AreTheAmbientLightWhereNothingElseIsSeen) {
    test::SceneBuilder b;
    b.square({0, 0, 0}, {0, 1, 0}, 1, b.material(test::matte(0.5F)));
    b.scene.ambient = {0.2F, 0.2F, 0.2F};
    const test::PathScene scene(b.finish());
    const auto floor = scene.see({0, 1, 0}, {0.1F, -1, 0}, 16384, test::bouncesAlone(0));
    EXPECT_NEAR(floor.mean[0], 0.1, 5 * floor.error[0] + 1e-6);
    EXPECT_EQ(scene.see({0, 1, 0}, {0, 1, 0}, 10).mean[0], 0) << "cameras do not see it";
}

} // namespace
} // namespace rtcore
