// Shadows that are looked up fall where those by rays do.
#include "rtcore/shading/light/shadow_maps.h"

#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>

namespace rtcore {
namespace {

using test::SceneBuilder;
using test::TracedScene;

/// A floor at y = 0, and above it, 2 away from the middle, a board of half side 1 of some material.
TracedScene boardAboveFloor(const Light& light, const Material& board) {
    SceneBuilder b;
    b.square({0.03F, 0, 0.05F}, {0, 1, 0}, 6, b.material(test::matte(0.5F)));
    b.square({2, 1, 0}, {0, 1, 0}, 1, b.material(board));
    b.scene.lights = {light};
    return TracedScene(b.finish());
}

std::unique_ptr<const ShadowMaps> mapsOf(const TracedScene& s) {
    const std::atomic<bool> cancel{false};
    return ShadowMaps::make(s.scene, s.tracer, cancel);
}

Light sun() {
    Light light;
    light.kind = LightKind::Directional;
    light.direction = normalize({0, -1, 0});
    return light;
}

constexpr Vec3 kUp{0, 1, 0};

TEST(ShadowMaps, OfTheSunHaveTheEdgesOfWhatThrowsThem) {
    const TracedScene s = boardAboveFloor(sun(), test::matte(0.5F));
    const auto maps = mapsOf(s);
    ASSERT_NE(maps, nullptr);
    for (float x = -5; x < 5; x += 0.01F) {
        const float fromEdge = std::min(std::abs(x - 1), std::abs(x - 3));
        if (fromEdge < 0.05F) continue;
        const bool dark = x > 1 && x < 3;
        EXPECT_EQ(maps->of(0).arriving({x, 0, 0.1F}, kUp), dark ? Colour{} : kWhite) << x;
        EXPECT_EQ(maps->of(0).arriving({x, 1.5F, 0.1F}, {}), kWhite) << "above the board";
        EXPECT_EQ(maps->of(0).arriving({x, 0.5F, 0.1F}, {}), dark ? Colour{} : kWhite) << "in the air below";
    }
}

TEST(ShadowMaps, OfALightGrowWithTheDistance) {
    const TracedScene s = boardAboveFloor(test::pointLight({0, 2, 0}, 10), test::matte(0.5F));
    const auto maps = mapsOf(s);
    // The board lies half way down: its shadow is twice as far and twice as wide, from 2 to 6.
    for (float x = -5; x < 5; x += 0.01F) {
        if (std::abs(x - 2) < 0.1F) continue;
        EXPECT_EQ(maps->of(0).arriving({x, 0, 0.1F}, kUp), x > 2 ? Colour{} : kWhite) << x;
    }
}

TEST(ShadowMaps, NothingThatIsLitDarkensItself) {
    for (const Vec3 place : {Vec3{0, 0.2F, 0}, Vec3{4, 3, 1}, Vec3{-5, 0.5F, -5}}) {
        SceneBuilder b;
        b.square({0.03F, 0, 0.05F}, kUp, 6, b.material(test::matte(0.5F)));
        b.scene.lights = {test::pointLight(place, 1)};
        const TracedScene s(b.finish());
        const auto maps = mapsOf(s);
        for (float x = -5.9F; x < 6; x += 0.07F) {
            for (float z = -5.9F; z < 6; z += 0.11F)
                ASSERT_EQ(maps->of(0).arriving({x, 0, z}, kUp), kWhite) << x << ' ' << z;
        }
    }
}

TEST(ShadowMaps, AreTintedByGlass) {
    Material pane = test::glass();
    pane.transmission = {0.9F, 0.5F, 0.1F};
    const TracedScene s = boardAboveFloor(sun(), pane);
    const auto maps = mapsOf(s);
    ShadowTracer rays;
    MaterialTable materials;
    materials.prepare(s.scene, {});
    rays.begin(s.scene, s.tracer, {}, materials.clear());
    RayWave wave;
    wave.push({{2, 0.01F, 0.1F}, 0, kUp, 100});
    RayStatistics statistics;
    const Colour traced = rays.transmittance(wave, s.scene.lights[0].light, statistics)[0];
    const Colour found = maps->of(0).arriving({2, 0, 0.1F}, kUp);
    EXPECT_NEAR(found.r, traced.r, 0.003);
    EXPECT_NEAR(found.g, traced.g, 0.003);
    EXPECT_NEAR(found.b, traced.b, 0.003);
    EXPECT_LT(found.b, 0.2F * found.r);

    RenderSettings settings;
    EXPECT_TRUE(maps->suit(settings));
    settings.refractions = false;
    EXPECT_FALSE(maps->suit(settings)) << "glass is opaque then";
}

TEST(ShadowMaps, OfAnOpaqueSceneSuitAnySettings) {
    const TracedScene s = boardAboveFloor(sun(), test::matte(0.5F));
    RenderSettings settings;
    settings.textures = settings.refractions = false;
    EXPECT_TRUE(mapsOf(s)->suit(settings));
}

TEST(ShadowMaps, ALightShinesOutOfItsFitting) {
    SceneBuilder b;
    b.square({0, 0, 0}, kUp, 6, b.material(test::matte(0.5F)));
    b.sphere({0, 3, 0}, 0.2F, 8, b.material(test::matte(0.5F)));
    Light inside = test::pointLight({0, 3, 0}, 1);
    inside.radius = 0.3F;
    Light enclosed = inside;
    enclosed.radius = 0;
    b.scene.lights = {inside, enclosed};
    const TracedScene s(b.finish());
    const auto maps = mapsOf(s);
    EXPECT_EQ(maps->of(0).arriving({1, 0, 1}, kUp), kWhite);
    EXPECT_EQ(maps->of(1).arriving({1, 0, 1}, kUp), Colour{});
}

TEST(ShadowMaps, CanBeGivenUp) {
    const TracedScene s = boardAboveFloor(sun(), test::matte(0.5F));
    const std::atomic<bool> cancel{true};
    EXPECT_EQ(ShadowMaps::make(s.scene, s.tracer, cancel), nullptr);
}

} // namespace
} // namespace rtcore
