// Directional lights that are as large as the sun: their light and shadows in closed form, and their disc
// where mirrors and panes show it.
#include "support/small_scene.h"

#include "rtcore/scene/metallic_roughness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rtcore {
namespace light_disc {
namespace {

using test::kPi;
using test::SceneBuilder;
using test::TracedScene;

/// A directional light of irradiance 1, from `to`, seen under an angle in degrees.
Light sunFrom(Vec3 to, double degrees) {
    Light light;
    light.kind = LightKind::Directional;
    light.direction = -normalize(to);
    light.discSine = static_cast<float>(std::sin(degrees * kPi / 360));
    return light;
}

double radianceOfDisc(double degrees) {
    const double sine = std::sin(degrees * kPi / 360);
    return 1 / (kPi * sine * sine);
}

RenderSettings sampled(int samples) {
    RenderSettings settings = test::exactSettings();
    settings.areaLights.samples = samples;
    return settings;
}

Material metal(float roughness) {
    Material m;
    setMetallicRoughness(m, kWhite * 0.9F, 1, roughness);
    return m;
}

/// A mirror, pane or metal at z = 0, with a light of that angle before and behind it in the line of sight.
TracedScene facing(const Material& material, double degrees) {
    SceneBuilder b;
    b.square({0, 0, 0}, {0, 0, 1}, 1, b.material(material));
    b.scene.lights = {sunFrom({0, 0, 1}, degrees), sunFrom({0, 0, -1}, degrees)};
    return TracedScene(b.finish());
}
double seen(const TracedScene& scene, Vec3 direction = {0, 0, -1},
            const RenderSettings& settings = sampled(16)) {
    return static_cast<double>(scene.trace({0, 0, 3}, direction, settings).radiance.r);
}

TEST(LightDisc, LightsAnOpenFloorAsASunWithoutASize) {
    for (const double degrees : {0.53, 5.0, 40.0}) {
        for (const double tilt : {0.0, 40.0, 65.0}) {
            SceneBuilder b;
            b.square({}, {0, 1, 0}, 1, b.material(test::matte(1)));
            b.scene.lights = {sunFrom(test::atAngle(tilt), degrees)};
            const TracedScene s(b.finish());
            const double expected = std::cos(tilt * kPi / 180);
            const double irradiance = static_cast<double>(s.see({0.01F, 1, 0.02F}, {}, sampled(2048))) * kPi;
            EXPECT_NEAR(irradiance, expected, 1e-3 * expected) << degrees << ", " << tilt;
        }
    }
}

TEST(LightDisc, WithoutSamplesItIsThatSunToTheBit) {
    SceneBuilder b;
    b.square({}, {0, 1, 0}, 1, b.material(test::matte(0.7F)));
    b.scene.lights = {sunFrom({1, 2, 0.5F}, 0.53)};
    Scene scene = b.finish();
    const float soft = TracedScene(scene).see({0, 1, 0.2F}, {}, sampled(0));
    scene.lights[0].light.discSine = 0;
    EXPECT_EQ(TracedScene(scene).see({0, 1, 0.2F}, {}, sampled(0)), soft);
    EXPECT_EQ(TracedScene(scene).see({0, 1, 0.2F}, {}, sampled(8)), soft) << "and a sun without a size";
}

/// An edge 50 above a floor: what a disc shows of itself beside it.
TEST(LightDisc, ThrowsThePenumbraOfADisc) {
    SceneBuilder b;
    b.square({}, {0, 1, 0}, 10, b.material(test::matte(1)));
    b.box({0, 50, -50}, {50, 50.1F, 50}, b.material(test::matte(1)));
    b.scene.lights = {sunFrom({0, 1, 0}, 0.53)};
    const TracedScene s(b.finish());
    const double radius = 50 * std::tan(0.265 * kPi / 180);
    for (const double part : {-1.05, -0.8, -0.4, 0.0, 0.3, 0.7, 1.05}) {
        const auto x = static_cast<float>(part * radius);
        const double t = std::clamp(-part, -1.0, 1.0);
        const double expected = 0.5 + (t * std::sqrt(1 - t * t) + std::asin(t)) / kPi;
        const double lit = static_cast<double>(s.see({x, 1, 0.01F}, {x, 0, 0}, sampled(1024))) * kPi;
        EXPECT_NEAR(lit, expected, 0.01) << part;
    }
}

TEST(LightDisc, IsSeenDirectlyInMirrorsAndThroughPanes) {
    const double disc = radianceOfDisc(0.53);
    EXPECT_GT(disc, 1e4);
    const TracedScene mirror = facing(test::mirror(0.5F), 0.53), pane = facing(test::glass(1), 0.53);
    EXPECT_NEAR(seen(mirror), 0.5 * disc, 1e-4 * disc);
    EXPECT_NEAR(seen(pane), disc, 1e-4 * disc);
    EXPECT_NEAR(seen(pane, {0, 0, 1}), disc, 1e-4 * disc);
    const double beside = 0.3 * kPi / 180;
    const Vec3 off{static_cast<float>(std::sin(beside)), 0, -static_cast<float>(std::cos(beside))};
    EXPECT_EQ(seen(mirror, off), 0);
    EXPECT_EQ(seen(pane, off), 0);
    EXPECT_NEAR(seen(facing(metal(0), 0.53)), 0.9 * disc, 0.01 * disc) << "chrome";
    EXPECT_EQ(seen(facing(test::mirror(0.5F), 0)), 0) << "without a size";
}

/// Where a lobe is asked about the light, the faded mirror of Whitted's ray tracing does not show it again.
TEST(LightDisc, CountsOnceWhereAHighlightStandsForIt) {
    for (const float roughness : {0.1F, 0.2F, 0.29F}) {
        const double point = seen(facing(metal(roughness), 0)), disc = seen(facing(metal(roughness), 0.53));
        EXPECT_GT(point, 1);
        EXPECT_NEAR(disc, point, 0.1 * point) << roughness; // and not 14,000 more
    }
    // A second mirror shows it.
    SceneBuilder b;
    b.square({0, 0, 0}, {0, 0, 1}, 1, b.material(metal(0.2F)));
    b.square({0, 0, 6}, normalize({0, 1, -1}), 1, b.material(test::mirror(1)));
    b.scene.lights = {sunFrom({0, 1, 0}, 10)};
    EXPECT_GT(seen(TracedScene(b.finish())), 0.05 * radianceOfDisc(10));
}

TEST(LightDisc, BlackOrSwitchedOffIsNotSeen) {
    TracedScene scene = facing(test::mirror(1), 5);
    scene.scene.lights[0].light.on = 0;
    EXPECT_EQ(seen(scene), 0);
    TracedScene black = facing(test::mirror(1), 5);
    black.scene.lights[0].light.intensity = {};
    EXPECT_EQ(seen(black), 0);
}

} // namespace
} // namespace light_disc
} // namespace rtcore
