#include "support/small_scene.h"
#include "support/steps.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rtcore {
namespace {

using test::atAngle;
using test::SceneBuilder;
using test::TracedScene;

TEST(Mirror, ShowsTheImageWhereItBelongs) {
    SceneBuilder b;
    b.square({0.3F, 0, 0.1F}, {0, 1, 0}, 10, b.material(test::mirror(0.8F)));
    b.square({2, 1, 0}, {-1, 0, 0}, 0.1F, b.material(test::emitter({10, 5, 1})));
    const TracedScene s(b.finish());
    const Vec3 eye{-2, 1, 0};
    const auto image = [&](float y, float z) { return s.trace(eye, Vec3{2, -1 + y, z} - eye).radiance; };
    EXPECT_NEAR(image(0, 0).r, 8, 1e-5);
    EXPECT_NEAR(image(0, 0).g, 4, 1e-5);
    EXPECT_NEAR(image(0, 0).b, 0.8, 1e-6);
    for (const float inside : {-0.0999F, 0.0999F}) {
        EXPECT_NEAR(image(inside, 0).r, 8, 1e-5);
        EXPECT_NEAR(image(0, inside).r, 8, 1e-5);
        EXPECT_EQ(image(inside * 1.002F, 0).r, 0);
        EXPECT_EQ(image(0, inside * 1.002F).r, 0);
    }
}

TEST(Mirror, WeighsEachChannel) {
    SceneBuilder b;
    Material m = test::mirror(0);
    m.mirror = {0.9F, 0.5F, 0};
    b.square({0, 0, 0}, {0, 1, 0}, 10, b.material(m));
    b.scene.background = {1, 1, 1};
    EXPECT_EQ(TracedScene(b.finish()).trace({1, 2, 3}, {0.1F, -1, 0}).radiance, (Colour{0.9F, 0.5F, 0}));
}

TEST(Mirror, FollowsSchlickWithFresnel) {
    SceneBuilder b;
    Material m = test::mirror(0.04F);
    m.fresnel = 1;
    m.mirrorScale = 0.5F;
    b.square({0.3F, 0, 0.1F}, {0, 1, 0}, 1000, b.material(m));
    b.scene.background = {1, 1, 1};
    const TracedScene s(b.finish());
    EXPECT_NEAR(s.see(atAngle(0) * 3, {}), 0.04 / 2, 1e-6);
    EXPECT_NEAR(s.see(atAngle(60) * 3, {}), 0.07 / 2, 1e-6);
    EXPECT_GT(s.see(atAngle(89.9) * 3, {}), 0.49);
}

TEST(Mirror, TwoThatFaceEachOtherSumAGeometricSeriesUpToTheDepth) {
    SceneBuilder b;
    Material m = test::mirror(0.9F);
    m.emission = {0.1F, 0.1F, 0.1F};
    const auto material = b.material(m);
    b.square({0, 0, 0}, {1, 0, 0}, 10, material);
    b.square({1, 0, 0}, {-1, 0, 0}, 10, material);
    const TracedScene s(b.finish());
    for (const int depth : {0, 1, 2, 5, 50, 1000}) {
        const double series = 0.1 * (1 - std::pow(0.9, depth + 1)) / (1 - 0.9);
        EXPECT_NEAR(s.trace({0.5F, 0.3F, 0.2F}, {1, 0, 0}, test::exactSettings(depth)).radiance.r, series,
                    1e-5)
            << depth;
    }
}

TEST(Mirror, ASphereShowsTheSurroundings) {
    SceneBuilder b;
    b.sphere({0, 0, 0}, 1, 24, b.material(test::mirror(1)));
    b.scene.background = {1, 2, 3};
    const TracedScene s(b.finish());
    for (const float y : test::steps(-0.97F, 1.0F, 0.05F)) {
        for (const float x : test::steps(-0.21F, 0.2F, 0.1F)) {
            EXPECT_EQ(s.trace({x, y, 5}, {0, 0, -1}).radiance, (Colour{1, 2, 3})) << x << ' ' << y;
        }
    }
}

TEST(Mirror, SmoothNormalsNeverSendRaysThroughTheSurface) {
    // Normals lean towards the viewer, so that the mirrored direction would lie below; behind is light.
    SceneBuilder b;
    b.square({0, 0, 0}, {0, 1, 0}, 10, b.material(test::mirror(1)));
    for (Vec3& n : b.buffers.normals) n = atAngle(-40);
    b.square({0, -1, 0}, {0, 1, 0}, 1000, b.material(test::emitter({100, 100, 100})));
    b.scene.background = {1, 1, 1};
    const TracedScene s(b.finish());
    for (const double degrees : test::steps(-85.0, 40.0, 5.0)) {
        EXPECT_EQ(s.see(atAngle(degrees) * 2, {}), 1) << degrees;
    }
}

TEST(Mirror, SwitchedOffItIsBlack) {
    SceneBuilder b;
    b.square({0, 0, 0}, {0, 1, 0}, 10, b.material(test::mirror(1)));
    b.scene.background = {1, 1, 1};
    RenderSettings settings;
    settings.reflections = false;
    const auto seen = TracedScene(b.finish()).trace({1, 2, 3}, {0.1F, -1, 0}, settings);
    EXPECT_EQ(seen.radiance, Colour{});
    EXPECT_EQ(seen.statistics.rays[static_cast<std::size_t>(RayKind::Mirror)], 0U);
}

} // namespace
} // namespace rtcore
