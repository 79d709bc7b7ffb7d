// Scenes whose indirect light is known.

#include "gathering_support.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace rtcore {
namespace {

TEST(IndirectLight, OfManyEmittersIsTheirPower) {
    // All of it arrives at black walls; emitters are small.
    test::SceneBuilder b;
    test::addRoom(b, {0, 0, 0}, {2, 2, 2}, b.material(test::matte(0)));
    const auto shining = b.material(test::emitter({10, 10, 10}));
    constexpr int kBoxes = 12; // of 12 triangles each: they are in a tree
    constexpr float kHalf = 0.03F;
    for (int i = 0; i < kBoxes; ++i) {
        const Vec3 at{0.4F + 0.4F * static_cast<float>(i % 4), 0.5F + 0.5F * static_cast<float>(i / 4), 0.9F};
        b.box(at - Vec3{kHalf, kHalf, kHalf}, at + Vec3{kHalf, kHalf, kHalf}, shining);
    }
    test::GatheringScene room(b.finish());
    room.addReceiversOfBox({0, 0, 0}, {2, 2, 2}, 800, 0.008F);
    room.learn(20);
    const double power = test::kPi * 10 * kBoxes * 6 * 4 * kHalf * kHalf;
    EXPECT_NEAR(room.mean().r / (power / 24), 1, 0.03); // some of it falls on other boxes
}

TEST(IndirectLight, OfAnEnclosureIsThatOfItsPower) {
    // Radiance rho phi / (pi A (1 - rho)) in all, of which the first term of the series is direct.
    for (const float albedo : {0.5F, 0.9F}) {
        test::SceneBuilder b;
        test::addRoom(b, {0, 0, 0}, {1, 1, 1}, b.material(test::matte(albedo)));
        Scene scene = b.finish();
        scene.lights = {test::pointLight({0.3F, 0.6F, 0.45F}, 1)};
        RenderSettings settings = test::exactSettings();
        settings.path.bounces = 64;
        test::GatheringScene enclosure(std::move(scene), settings);
        enclosure.addReceiversOfBox({0, 0, 0}, {1, 1, 1}, 800, 0.004F);
        enclosure.learn(25);
        const double expected = albedo / (1 - albedo) * 4 * test::kPi / 6;
        EXPECT_NEAR(enclosure.mean().r / expected, 1, 0.01) << albedo;
    }
}

TEST(IndirectLight, OfASphereIsTheSameEverywhere) {
    constexpr float kAlbedo = 0.6F;
    test::SceneBuilder b;
    b.sphere({0, 0, 0}, 1, 48, b.material(test::matte(kAlbedo)));
    Scene scene = b.finish();
    scene.lights = {test::pointLight({0, 0, 0}, 1)};
    RenderSettings settings = test::exactSettings();
    settings.path.bounces = 64;
    test::GatheringScene sphere(std::move(scene), settings);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 out = sphere.random.unitVector();
        Ray ray{{0, 0, 0}, 0, out, 10};
        RayWave rays;
        HitWave hits;
        rays.push(ray);
        sphere.traced.tracer.intersect(RayKind::Primary, rays, hits);
        ASSERT_TRUE(hits.isHit(0));
        const Vec3 face = normalize(sphere.traced.scene.mesh().geometricNormal(hits.triangle[0])) * -1.0F;
        sphere.receivers.push_back({out * hits.t[0], face, out * -1.0F, 0.006F});
    }
    sphere.learn(50);
    const double expected = kAlbedo / (1 - kAlbedo);
    EXPECT_NEAR(sphere.mean().r / expected, 1, 0.01);
    double square = 0;
    for (const Receiver& receiver : sphere.receivers)
        square += std::pow(sphere.at(receiver).r / expected - 1, 2);
    EXPECT_LT(std::sqrt(square / 2000), 0.02);
}

TEST(IndirectLight, WhiteObjectsUnderAWhiteSkyAreWhite) {
    test::SceneBuilder b;
    const auto white = b.material(test::matte(1));
    b.quad({-3, 0, -3}, {-3, 0, 3}, {3, 0, 3}, {3, 0, -3}, white);
    b.box({-1, 0, -1}, {0, 1.5F, 0}, white);
    b.box({0.2F, 0, 0.2F}, {1, 0.4F, 1.4F}, white);
    Scene scene = b.finish();
    scene.background = {1, 1, 1};
    RenderSettings settings = test::exactSettings();
    settings.path.bounces = 200;
    settings.path.rouletteFrom = 1000;
    test::GatheringScene furnace(std::move(scene), settings);
    furnace.addReceivers({-1, 0, 0}, {1, 0, 0}, {0, 1.5F, 0}, {0, 0, 1}, 1000, 0.006F);
    furnace.addReceivers({0, 0, -1}, {0, 0, 1}, {0, 1.5F, 0}, {1, 0, 0}, 1000, 0.006F);
    furnace.addReceivers({0, 0, 0}, {0.2F, 0, 0}, {0, 0, 1.4F}, {0, 1, 0}, 1000, 0.006F);
    furnace.addReceivers({0, 0, -3}, {3, 0, 0}, {0, 0, 3}, {0, 1, 0}, 1000, 0.006F);
    furnace.learn(30);
    EXPECT_NEAR(furnace.mean().r / test::kPi, 1, 0.005);
    double worst = 0;
    for (Receiver receiver : furnace.receivers) {
        worst = std::max(worst, std::abs(furnace.at(receiver).r / test::kPi - 1));
        // Of light from above the face alone.
        receiver.normal = normalize(receiver.face + Vec3{0.3F, 0.2F, -0.1F});
        const double seen = test::kPi * (1 + dot(receiver.face, receiver.normal)) / 2;
        worst = std::max(worst, std::abs(furnace.at(receiver).r / seen - 1));
    }
    EXPECT_LT(worst, 0.04);
}

/// [0,1]^3 with an emitter of 0.4 x 0.4 in the middle of its ceiling.
Scene cornellCube() {
    test::SceneBuilder b;
    const auto coloured = [&](Colour diffuse) {
        Material m;
        m.diffuse = diffuse;
        return b.material(m);
    };
    const auto white = coloured({0.725F, 0.71F, 0.68F});
    const auto left = coloured({0.63F, 0.065F, 0.05F}), right = coloured({0.14F, 0.45F, 0.091F});
    b.quad({0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}, white);
    b.quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, white);
    b.quad({0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}, white);
    b.quad({0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}, left);
    b.quad({1, 0, 0}, {1, 0, 1}, {1, 1, 1}, {1, 1, 0}, right);
    const auto shining = b.material(test::emitter({1, 1, 1}));
    constexpr std::array<float, 4> kAt{0, 0.3F, 0.7F, 1};
    for (std::size_t z = 0; z < 3; ++z) {
        for (std::size_t x = 0; x < 3; ++x)
            b.quad({kAt[x], 1, kAt[z]}, {kAt[x + 1], 1, kAt[z]}, {kAt[x + 1], 1, kAt[z + 1]},
                   {kAt[x], 1, kAt[z + 1]}, x == 1 && z == 1 ? shining : white);
    }
    return b.finish();
}

TEST(IndirectLight, OfTheCornellCubeIsThatOfSixMillionPaths) {
    constexpr float kPixel = 0.0015F;
    RenderSettings settings = test::exactSettings();
    settings.path.bounces = 40;
    test::GatheringScene cube(cornellCube(), settings);
    cube.addReceiversOfBox({0, 0, 0}, {1, 1, 1}, 3000, kPixel);
    cube.budget = {16384, 1536};
    struct Known {
        Vec3 point, normal;
        Colour irradiance;
    };
    const std::array<Known, 5> known{
        Known{{0.5F, 0, 0.5F}, {0, 1, 0}, {0.26302F, 0.23790F, 0.20829F}},
        Known{{0.1F, 0, 0.1F}, {0, 1, 0}, {0.20414F, 0.15494F, 0.13719F}},
        Known{{0, 0.5F, 0.5F}, {1, 0, 0}, {0.26685F, 0.26377F, 0.22836F}},
        Known{{0.5F, 0.5F, 0}, {0, 0, 1}, {0.26742F, 0.24196F, 0.21184F}},
        Known{{0.1F, 1, 0.5F}, {0, -1, 0}, {0.14859F, 0.08166F, 0.06164F}},
    };
    cube.learn(160);
    for (const Known& each : known) {
        const Colour found = cube.at(test::receiverAt(each.point, each.normal, kPixel));
        EXPECT_NEAR(found.r / each.irradiance.r, 1, 0.02) << each.point.x << ' ' << each.point.y;
        EXPECT_NEAR(found.g / each.irradiance.g, 1, 0.02) << each.point.x << ' ' << each.point.y;
        EXPECT_NEAR(found.b / each.irradiance.b, 1, 0.02) << each.point.x << ' ' << each.point.y;
    }
}

} // namespace
} // namespace rtcore
