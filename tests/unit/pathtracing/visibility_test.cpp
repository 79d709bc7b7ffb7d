// Points sample the lights that they see: the mean stays what it was, and noise goes.
#include "rtcore/pathtracing/visibility_cache-inl.h"

#include "path_support.h"

#include "support/random_numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {
namespace {

namespace plain = HWY_NAMESPACE;

constexpr float kAlbedo = 0.5F;

/// A black box of 4 x 4 x 2 m with a matte floor, open where its roof has a hole of 0.5 x 0.5 m in one
/// corner, under an even sky.
Scene roomUnderTheSky() {
    test::SceneBuilder b;
    const std::uint32_t black = b.material(test::matte(0)), grey = b.material(test::matte(kAlbedo));
    b.quad({-2, 0, 2}, {2, 0, 2}, {2, 0, -2}, {-2, 0, -2}, grey);
    b.box({-2.2F, 0, -2.2F}, {-2, 2, 2.2F}, black);
    b.box({2, 0, -2.2F}, {2.2F, 2, 2.2F}, black);
    b.box({-2, 0, -2.2F}, {2, 2, -2}, black);
    b.box({-2, 0, 2}, {2, 2, 2.2F}, black);
    b.box({-2, 2, -2}, {1, 2.01F, 2}, black);
    b.box({1.5F, 2, -2}, {2, 2.01F, 2}, black);
    b.box({1, 2, -2}, {1.5F, 2.01F, 1}, black);
    b.box({1, 2, 1.5F}, {1.5F, 2.01F, 2}, black);
    b.scene.background = {1, 1, 1};
    return b.finish();
}
constexpr Vec3 kInside{0, 1.9F, 0};

/// The light of the hole's lower edges, from a point of the floor; the plate is thin.
double seenOfHole(Vec3 point) {
    std::array<std::array<double, 3>, 4> corners{};
    constexpr std::array<std::array<double, 2>, 4> kCorners{{{1, 1}, {1.5, 1}, {1.5, 1.5}, {1, 1.5}}};
    for (std::size_t i = 0; i < 4; ++i)
        corners[i] = {kCorners[i][0] - static_cast<double>(point.x), 2 - static_cast<double>(point.y),
                      kCorners[i][1] - static_cast<double>(point.z)};
    return test::lambertSum(corners, {0, 1, 0});
}

TEST(Visibility, OfAWindowLeavesTheMeanAndTakesTheNoise) {
    test::PathScene scene(roomUnderTheSky());
    for (const Vec3 at : {Vec3{0.9F, 0, 0.8F}, Vec3{-1.5F, 0, -1}}) {
        const Vec3 direction = normalize(at - kInside);
        test::PathLimits limits = test::bouncesAlone(0);
        limits.strategy = SamplingStrategy::NextEvent;
        scene.lights.setVisibility({});
        const double before = scene.see(kInside, direction, 40000, limits).error[0];
        scene.learn(kInside, 3, 64);
        // Through the plate's thickness a little less is seen than through its lower edges.
        const double expected = kAlbedo * seenOfHole(at);
        test::expectLight(scene, kInside, direction, 40000, test::bouncesAlone(0), expected, "through a hole",
                          0.02 * expected);
        EXPECT_LT(scene.see(kInside, direction, 40000, limits).error[0], before / 3);
    }
}

/// A wall between two rooms, each with a light; and no sky.
Scene twoRooms() {
    test::SceneBuilder b;
    const std::uint32_t grey = b.material(test::matte(kAlbedo));
    b.quad({-4, 0, 4}, {4, 0, 4}, {4, 0, -4}, {-4, 0, -4}, grey);
    b.box({-0.1F, 0, -4}, {0.1F, 6, 4}, grey);
    Light ball = test::pointLight({2, 2, 0}, 10);
    ball.kind = LightKind::Sphere;
    ball.radius = 0.2F;
    b.scene.lights = {test::pointLight({-2, 2, 0}, 10), ball};
    return b.finish();
}

TEST(Visibility, OfALightBehindAWallLeavesTheMeanAndTakesTheNoise) {
    test::PathScene scene(twoRooms());
    const Vec3 eye{-1, 5, 3}, direction = normalize(Vec3{-0.3F, 0, 0.5F} - eye);
    const test::PathLimits limits = test::bouncesAlone(0);
    const test::PathMean before = scene.see(eye, direction, 20000, limits);
    scene.learn(eye, 4, 64);
    const Vec3 point{-0.3F, 0, 0.5F}, to = Vec3{-2, 2, 0} - point;
    const double distance = length(to);
    const double expected = kAlbedo / test::kPi * 10 * static_cast<double>(to.y) / std::pow(distance, 3);
    test::expectLight(scene, eye, direction, 20000, limits, expected, "beside a wall");
    EXPECT_LT(scene.see(eye, direction, 20000, limits).error[0], before.error[0] / 3);
}

/// Rooms in a row along x, 4 m wide, each with lights or boxes that shine below its roof: more than are
/// weighed one by one.
Scene rowOfRooms(bool boxes) {
    test::SceneBuilder b;
    const std::uint32_t grey = b.material(test::matte(kAlbedo));
    const std::uint32_t shining = b.material(test::emitter({20, 20, 20}));
    b.quad({0, 0, 2}, {48, 0, 2}, {48, 0, -2}, {0, 0, -2}, grey);
    for (int room = 0; room < 12; ++room) {
        const auto x = 4 * static_cast<float>(room);
        b.box({x - 0.05F, 0, -2}, {x + 0.05F, 4, 2}, grey);
        for (int k = 0; k < 4; ++k) {
            const Vec3 at{x + 0.8F * static_cast<float>(k + 1), 3, 0.4F * static_cast<float>(k) - 0.6F};
            if (boxes) b.box(at, at + Vec3{0.1F, 0.1F, 0.1F}, shining);
            if (!boxes) b.scene.lights.emplace_back(test::pointLight(at, 5));
        }
    }
    return b.finish();
}

TEST(Visibility, OfManyLightsInOtherRoomsLeavesTheMeanAndTakesTheNoise) {
    for (const bool boxes : {false, true}) {
        test::PathScene scene(rowOfRooms(boxes));
        const Vec3 eye{22, 3.5F, 1.5F}, direction = normalize(Vec3{20.4F, 0, -1} - eye);
        const test::PathLimits limits = test::bouncesAlone(0);
        const test::PathMean before = scene.see(eye, direction, 20000, limits);
        scene.learn(eye, 30, 96);
        for (const SamplingStrategy strategy : {SamplingStrategy::Both, SamplingStrategy::NextEvent}) {
            test::PathLimits by = limits;
            by.strategy = strategy;
            const test::PathMean seen = scene.see(eye, direction, 20000, by);
            EXPECT_NEAR(seen.mean[0], before.mean[0], 5 * std::hypot(seen.error[0], before.error[0]))
                << boxes;
            EXPECT_LT(seen.error[0], 0.8 * before.error[0]) << boxes;
        }
    }
}

/// Samples in some cells that see some bins; reproducible.
std::vector<VisibilitySample> someSamples() {
    test::Random random(5);
    const auto below = [&](std::size_t count) { return random.index(count); };
    std::vector<VisibilitySample> samples(3000);
    for (std::uint32_t i = 0; i < samples.size(); ++i) {
        VisibilitySample& sample = samples[i];
        const auto at = [&] { return static_cast<float>(below(1000)) / 500 - 1; };
        sample.position = {at(), at(), at()};
        sample.normal = normalize(Vec3{at(), at(), at()} + Vec3{1e-3F, 0, 0});
        sample.number = i;
        for (VisibilitySample::Try& each : sample.sky) {
            each.bin = static_cast<std::uint8_t>(below(256));
            const bool seen = each.bin / 16 == 3 && sample.position.x > 0;
            each.seen = seen ? static_cast<std::uint8_t>(below(255)) : std::uint8_t{0};
        }
        for (std::uint8_t& light : sample.light) light = static_cast<std::uint8_t>(below(256));
    }
    return samples;
}

TEST(Visibility, DensitiesAreThoseOfTheSamples) {
    HdrImage image(16, 8);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 16; ++x) image.at(x, y) = kWhite * (y < 4 ? 1 + static_cast<float>(x) / 4 : 0.1F);
    const Environment environment = Environment::fromEquirectangular(image, "");
    EnvironmentSampler surroundings;
    surroundings.prepare({&environment, {}, TexelFilter::Bilinear});
    VisibilityCache cache;
    cache.build(someSamples(), 32, 7, surroundings.scalarIrradiance());
    const VisibilityRows rows = cache.rows();
    ASSERT_GT(rows.cells, 50);
    test::Random random(2);
    const auto bits = [&] { return static_cast<std::uint32_t>(random.index(std::size_t{1} << 32U)); };
    for (std::uint32_t cell = 0; cell < static_cast<std::uint32_t>(rows.cells); cell += 11) {
        // The solid angle of all directions, by samples.
        double sum = 0, squares = 0;
        constexpr int kCount = 4000;
        for (int i = 0; i < kCount; ++i) {
            const std::uint32_t across = bits();
            const auto numbers = plain::visibleNumbers<float>(rows, cell, across, bits());
            const Vec3 direction =
                plain::environmentDirection<float>(surroundings.rows(), numbers.across, numbers.down);
            const double part = 1 / static_cast<double>(plain::visibleDensity<float>(surroundings.rows(),
                                                                                     rows, cell, direction));
            sum += part;
            squares += part * part;
        }
        const double mean = sum / kCount, error = std::sqrt((squares / kCount - mean * mean) / kCount);
        EXPECT_NEAR(mean, 4 * test::kPi, 5 * error) << cell;
        for (std::uint32_t k = 0; k < 7; ++k) {
            const float part = plain::visiblePart<float>(rows, k, cell);
            EXPECT_TRUE(part > 0 && part <= 1) << cell << " " << k;
        }
    }
}

TEST(Visibility, OrderOfSamplesDoesNotMatter) {
    std::vector<VisibilitySample> samples = someSamples();
    VisibilityCache one, other;
    one.build(samples, 32, 7, 1);
    std::ranges::reverse(samples);
    other.build(samples, 32, 7, 1);
    const VisibilityRows a = one.rows(), b = other.rows();
    ASSERT_EQ(a.cells, b.cells);
    const auto cells = static_cast<std::size_t>(a.cells);
    EXPECT_TRUE(std::ranges::equal(std::span(a.rowStarts, cells * 17), std::span(b.rowStarts, cells * 17)));
    EXPECT_TRUE(
        std::ranges::equal(std::span(a.columnStarts, cells * 272), std::span(b.columnStarts, cells * 272)));
    EXPECT_TRUE(std::ranges::equal(std::span(a.lights, cells * 7), std::span(b.lights, cells * 7)));
}

TEST(Visibility, IsTheSameForAnyNumberOfThreads) {
    test::PathScene scene(roomUnderTheSky());
    std::vector<std::vector<float>> seen;
    for (const int threads : {1, 3}) {
        scene.learn(kInside, 3, 80, threads);
        const VisibilityRows rows = scene.lights.rows().visible;
        seen.emplace_back(rows.surroundings, rows.surroundings + rows.cells);
    }
    EXPECT_GT(seen[0].size(), 20U);
    EXPECT_EQ(seen[0], seen[1]);
}

TEST(Visibility, NumbersThatAreNoneHaveACell) {
    VisibilityCache cache;
    cache.build(someSamples(), 32, 7, 1);
    const VisibilityRows rows = cache.rows();
    const float nan = std::numeric_limits<float>::quiet_NaN(), all = std::numeric_limits<float>::infinity();
    for (const float x : {nan, all, -all, 1e30F}) {
        EXPECT_LT(plain::cellOf<float>(rows, {x, x, x}, {x, x, x}), static_cast<std::uint32_t>(rows.cells));
        EXPECT_LT(plain::cellOf<float>(rows, {x, 0, 0}, {0, x, 0}), static_cast<std::uint32_t>(rows.cells));
    }
    cache.build({}, 32, 7, 1);
    EXPECT_TRUE(cache.empty());
}

} // namespace
} // namespace rtcore
