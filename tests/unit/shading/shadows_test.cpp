#include "support/small_scene.h"
#include "support/steps.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rtcore {
namespace {

using test::atAngle;
using test::SceneBuilder;
using test::TracedScene;

/// Fraction of the light from `degrees` off the zenith that arrives on a floor at y = -3 below what `add`
/// puts between them.
template <typename Add>
Colour arriving(double degrees, Add&& add, const RenderSettings& settings = test::exactSettings()) {
    SceneBuilder b;
    b.square({0.3F, -3, 0.1F}, {0, 1, 0}, 100, b.material(test::matte(1)));
    b.scene.lights.push_back(test::pointLight(Vec3{0, -3, 0} + atAngle(degrees) * 20, 1000));
    const TracedScene bare(b.finish());
    SceneBuilder c;
    c.square({0.3F, -3, 0.1F}, {0, 1, 0}, 100, c.material(test::matte(1)));
    c.scene.lights = bare.scene.lights;
    add(c);
    const TracedScene covered(c.finish());
    // Seen from below the cover.
    const Vec3 eye{-1, -2.5F, 0};
    const Colour all = bare.trace(eye, Vec3{0, -3, 0} - eye, settings).radiance;
    const Colour rest = covered.trace(eye, Vec3{0, -3, 0} - eye, settings).radiance;
    return {rest.r / all.r, rest.g / all.g, rest.b / all.b};
}

TEST(Shadow, IsExactlyBlackBehindAWall) {
    for (const double degrees : {0, 30, 70}) {
        EXPECT_EQ(arriving(degrees,
                           [](SceneBuilder& b) {
                               b.square({0, 0, 0}, {0, 1, 0}, 50, b.material(test::matte(1)));
                           }),
                  Colour{});
        EXPECT_EQ(arriving(degrees,
                           [](SceneBuilder& b) { // in a scene where light passes elsewhere
                               b.square({0, 0, 0}, {0, -1, 0}, 50, b.material(test::matte(1)));
                               b.square({900, 0, 0}, {0, 1, 0}, 1, b.material(test::glass()));
                           }),
                  Colour{});
    }
}

TEST(Shadow, SwitchedOffNothingIsDark) {
    RenderSettings settings;
    settings.shadows = false;
    const Colour all = arriving(
        30,
        [](SceneBuilder& b) {
            b.square({0, 0, 0}, {0, 1, 0}, 50, b.material(test::matte(1)));
        },
        settings);
    EXPECT_EQ(all, kWhite);
}

TEST(Shadow, OnlyWhatIsBetweenCasts) {
    const Colour all = arriving(0, [](SceneBuilder& b) {
        b.square({0, 18, 0}, {0, 1, 0}, 50, b.material(test::matte(1))); // above the light
        b.square({5, 0, 0}, {0, 1, 0}, 1, b.material(test::matte(1)));   // beside it
    });
    EXPECT_EQ(all, kWhite);
}

TEST(Shadow, ALightInTheCeilingShines) {
    // Exactly in its plane: which side of it rounding puts the end of a ray on must not matter.
    SceneBuilder b;
    b.square({0.3F, 0, 0.1F}, {0, 1, 0}, 20, b.material(test::matte(1)));
    b.square({0.2F, 2.7F, 0.4F}, {0, -1, 0}, 20, b.material(test::matte(1)));
    b.scene.lights.push_back(test::pointLight({0, 2.7F, 0}, 100));
    const TracedScene s(b.finish());
    for (const float x : test::steps(-8.0F, 8.0F, 0.173F)) {
        const double d2 = x * x + 2.7 * 2.7;
        const double expected = 100 / d2 * (2.7 / std::sqrt(d2)) / test::kPi;
        EXPECT_NEAR(s.see({x + 0.5F, 1, 0}, {x, 0, 0}), expected, expected * 1e-4) << x;
    }
}

TEST(Shadow, ThinGlassTints) {
    Material m = test::glass();
    m.transmission = {0.5F, 1, 0};
    const auto pane = [&](SceneBuilder& b) { b.square({0, 0, 0}, {0, 1, 0}, 50, b.material(m)); };
    const Colour straight = arriving(0, pane);
    EXPECT_NEAR(straight.r, 0.5 * 0.923077, 1e-5);
    EXPECT_NEAR(straight.g, 0.923077, 1e-5);
    EXPECT_EQ(straight.b, 0);
    const double r = 0.089187;
    EXPECT_NEAR(arriving(60, pane).g, (1 - r) / (1 + r), 1e-5);
}

TEST(Shadow, ASolidOfGlassTakesFresnelTwiceAndAbsorbs) {
    Material m = test::glass();
    m.transmission = {0.25F, 0.5F, 1};
    m.attenuationDistance = static_cast<float>(std::log(4) / 0.5); // red: e^(-s/2)
    const auto slab = [&](SceneBuilder& b) { b.box({-8, -1, -8}, {8, 0, 8}, b.material(m)); };
    const Colour straight = arriving(0, slab);
    EXPECT_NEAR(straight.r, 0.96 * 0.96 * std::exp(-0.5), 2e-5);
    EXPECT_NEAR(straight.g, 0.96 * 0.96 * std::exp(-0.25), 2e-5);
    EXPECT_NEAR(straight.b, 0.96 * 0.96, 2e-5);
    const double r = 0.089187; // straight on, at 60 degrees at both faces; twice the way
    EXPECT_NEAR(arriving(60, slab).r, (1 - r) * (1 - r) * std::exp(-1.0), 2e-5);
}

TEST(Shadow, ASolidOfGlassTintsOnceWithoutAnAttenuationDistance) {
    Material m = test::glass();
    m.transmission = {0.5F, 1, 1};
    const Colour through = arriving(0, [&](SceneBuilder& b) {
        b.box({-8, -1, -8}, {8, 0, 8}, b.material(m));
    });
    EXPECT_NEAR(through.r, 0.5 * 0.96 * 0.96, 1e-5);
    EXPECT_NEAR(through.g, 0.96 * 0.96, 1e-5);
}

TEST(Shadow, PanesMultiply) {
    const Colour through = arriving(0, [](SceneBuilder& b) {
        const auto glass = b.material(test::glass());
        for (int i = 0; i < 10; ++i) b.square({0, static_cast<float>(i), 0}, {0, 1, 0}, 50, glass);
    });
    EXPECT_NEAR(through.r, std::pow(0.923077, 10), 1e-5);
}

TEST(Shadow, WithoutRefractionsGlassCastsABlackOne) {
    RenderSettings settings;
    settings.refractions = false;
    EXPECT_EQ(arriving(
                  0,
                  [](SceneBuilder& b) {
                      b.square({0, 0, 0}, {0, 1, 0}, 50, b.material(test::glass()));
                  },
                  settings),
              Colour{});
}

TEST(Shadow, DirectionalAndSpotLightsCastToo) {
    SceneBuilder b;
    b.square({0.3F, 0, 0.1F}, {0, 1, 0}, 100, b.material(test::matte(1)));
    b.square({0, 1, 0}, {0, 1, 0}, 1, b.material(test::matte(1)));
    Light sun;
    sun.kind = LightKind::Directional;
    sun.direction = normalize({1, -1, 0});
    Light spot = test::pointLight({0, 5, 0}, 100);
    spot.kind = LightKind::Spot;
    spot.cosInner = 0.5F;
    spot.cosOuter = 0.4F;
    b.scene.lights = {sun};
    TracedScene s(b.finish());
    const auto lit = [&](float x) { return s.see({x, 0.5F, 30}, {x, 0, 0}) > 0; };
    EXPECT_FALSE(lit(1));
    EXPECT_FALSE(lit(1.99F));
    EXPECT_TRUE(lit(2.01F));
    EXPECT_TRUE(lit(-0.01F));
    s.scene.lights = {spot};
    EXPECT_FALSE(lit(1.24F)); // the edge at 1 throws its shadow to 1.25
    EXPECT_TRUE(lit(1.26F));
    EXPECT_FALSE(lit(20));
}

} // namespace
} // namespace rtcore
