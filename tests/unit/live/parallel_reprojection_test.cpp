/// Samples of parallel views, as these move, turn and are magnified.
#include "rtcore/live/reprojection.h"

#include "rtcore/simd/instruction_set.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace rtcore {
namespace {

constexpr int kViewSide = 64;
constexpr float kTurnDegree = 3.14159265F / 180, kViewWidth = 64; ///< a unit for each pixel

/// Turned by `yaw` about a vertical line that lies `pivot` before the eye; `width` units are seen.
ImagePlane planeAt(Vec3 eye, float width = kViewWidth, float yaw = 0, float pivot = 0) {
    Camera camera;
    camera.kind = CameraKind::Orthographic;
    camera.orthographicWidth = width;
    camera.forward = {std::sin(yaw), 0, -std::cos(yaw)};
    camera.eye = eye + Vec3{0, 0, -pivot} - camera.forward * pivot;
    return {CameraRays(camera, kViewSide, kViewSide), kViewSide, kViewSide};
}

/// Different for each pixel, and exact when it is packed.
Colour lightOfPixel(int x, int y) { return {static_cast<float>(x), static_cast<float>(y), 1}; }

/// Two walls across the view: the left half of it sees the near one, the right half the far one.
class ParallelView : public testing::Test {
  protected:
    ParallelView() {
        past.clear(planeAt({}));
        for (int y = 0; y < kViewSide; ++y)
            for (int x = 0; x < kViewSide; ++x) set(x, y, depthOf(x));
    }
    static float depthOf(int x) { return x < kViewSide / 2 ? 10.0F : 40.0F; }
    void set(int x, int y, float depth) {
        past.set(past.index(x, y), {.position = past.plane().inDepth(static_cast<float>(x) + 0.5F,
                                                                     static_cast<float>(y) + 0.5F, depth),
                                    .light = lightOfPixel(x, y)});
    }
    void setBackground(int x, int y, float depth) {
        set(x, y, depth);
        past.points[past.index(x, y)].state |= LiveSamples::kBackground;
    }
    void reprojectTo(const ImagePlane& plane, int threads = 1) {
        now.resize(plane);
        reprojection.reproject(layers, now, threads);
    }
    Colour seen(int x, int y) const { return present.light(present.index(x, y)); }
    bool known(int x, int y) const { return present.known(present.index(x, y)); }
    float staleness(int x, int y) const { return reprojection.staleness()[present.index(x, y)]; }

    LiveLayers layers, now;
    LiveSamples &past = layers.surface, &present = now.surface;
    Reprojection reprojection;
};

TEST_F(ParallelView, StaysWhereItIsWhereverAlongItsAxisTheEyeIs) {
    for (const float back : {0.0F, 5.0F, -9.5F}) {
        reprojectTo(planeAt({0, 0, back}));
        for (int y = 0; y < kViewSide; ++y) {
            for (int x = 0; x < kViewSide; ++x) {
                ASSERT_TRUE(known(x, y)) << back;
                EXPECT_EQ(seen(x, y), lightOfPixel(x, y));
                EXPECT_LT(staleness(x, y), 1e-4F);
            }
        }
    }
    reprojectTo(planeAt({0, 0, -20})); // the plane of the eye has passed the near wall
    EXPECT_FALSE(known(10, 30));
    EXPECT_EQ(seen(40, 30), lightOfPixel(40, 30));
}

TEST_F(ParallelView, MovesAlikeInEveryDepth) {
    for (int y = 0; y < kViewSide; ++y) setBackground(50, y, 3);
    reprojectTo(planeAt({3, -2, 1}));
    for (int y = 0; y + 2 < kViewSide; ++y)
        for (int x = 0; x + 3 < kViewSide; ++x)
            EXPECT_EQ(seen(x, y), lightOfPixel(x + 3, y + 2)) << x << ", " << y;
    for (int y = 0; y < kViewSide; ++y) EXPECT_FALSE(known(kViewSide - 1, y));
    EXPECT_TRUE(present.background(present.index(47, 9)));
    EXPECT_LT(staleness(47, 9), 0.01F);
    reprojectTo(planeAt({0.25F, 0, 0}));
    EXPECT_NEAR(staleness(20, 15), 0.25F * 0.25F, 1e-3);
    EXPECT_NEAR(staleness(40, 15), 0.25F * 0.25F, 1e-3);
}

TEST_F(ParallelView, TurnsAboutALineThatStays) {
    constexpr float kYaw = 6 * kTurnDegree, kPivot = 10;
    reprojectTo(planeAt({}, kViewWidth, kYaw, kPivot));
    int samples = 0;
    for (int x = 4; x < kViewSide / 2; ++x) {
        const float aside = static_cast<float>(x) + 0.5F - kViewWidth / 2; // on the near wall, from the line
        const int column = static_cast<int>(std::floor(kViewWidth / 2 + aside * std::cos(kYaw)));
        ASSERT_TRUE(known(column, 20));
        samples += seen(column, 20) == lightOfPixel(x, 20) ? 1 : 0;
    }
    EXPECT_GE(samples, kViewSide / 2 - 6) << "but for one that shares its pixel with another";
    // The far wall moves aside by the sine of the angle for each unit that it is behind the line.
    const float shift = 30 * std::sin(kYaw), aside = (40.5F - kViewWidth / 2) * std::cos(kYaw);
    const int column = static_cast<int>(std::floor(kViewWidth / 2 + aside - shift));
    EXPECT_NEAR(seen(column, 20).r, 40, 1.01F);
}

TEST_F(ParallelView, IsMagnified) {
    reprojectTo(planeAt({}, 0.8F * kViewWidth));
    for (int x = 2; x < kViewSide - 2; ++x) {
        ASSERT_TRUE(known(x, 30)) << "gaps between samples are closed";
        const float before = kViewWidth / 2 + (static_cast<float>(x) + 0.5F - kViewWidth / 2) * 0.8F;
        EXPECT_NEAR(seen(x, 30).r, before - 0.5F, 1.01F);
    }
    reprojectTo(planeAt({}, 1.25F * kViewWidth));
    EXPECT_FALSE(known(2, 30)) << "what was not seen before";
    EXPECT_NEAR(seen(12, 30).r, (12.5F - kViewWidth / 2) * 1.25F + kViewWidth / 2 - 0.5F, 1.01F);
}

TEST_F(ParallelView, HidesTheFarThingInTheSamePixel) {
    past.set(past.index(0, 0), {.position = past.plane().inDepth(20.5F, 15.5F, 30), .light = {500, 0, 0}});
    reprojectTo(planeAt({}));
    EXPECT_EQ(seen(20, 15), lightOfPixel(20, 15));
    past.set(past.index(0, 0), {.position = past.plane().inDepth(20.5F, 15.5F, 1), .light = {500, 0, 0}});
    reprojectTo(planeAt({}));
    EXPECT_GT(seen(20, 15).r, 400);
}

TEST_F(ParallelView, HidesTheBackgroundBehindEverything) {
    past.set(past.index(0, 0),
             {.position = past.plane().inDepth(20.5F, 15.5F, 1), .light = {500, 0, 0}, .background = true});
    reprojectTo(planeAt({}));
    EXPECT_EQ(seen(20, 15), lightOfPixel(20, 15));
}

TEST_F(ParallelView, SoonAsksForTheBackgroundAnewWhereItTurns) {
    for (int y = 0; y < kViewSide; ++y)
        for (int x = 0; x < kViewSide; ++x) setBackground(x, y, 10);
    for (int i = 0; i < 4; ++i) {
        reprojectTo(planeAt({}));
        std::swap(layers, now);
    }
    reprojectTo(planeAt({1, 0, 0}));
    EXPECT_LT(staleness(20, 15), 0.1F);
    reprojectTo(planeAt({}, kViewWidth, 0.01F * kTurnDegree, 10));
    EXPECT_GT(staleness(20, 15), 0.9F);
}

TEST(ParallelReprojection, IsTheSameForEveryInstructionSetAndNumberOfThreads) {
    LiveLayers layers;
    LiveSamples& past = layers.surface;
    layers.resize(planeAt({}));
    std::mt19937 random(7);
    std::uniform_real_distribution<float> anywhere(-40, 40);
    for (std::size_t i = 0; i < past.size(); ++i) {
        past.set(i, {.position = {anywhere(random), anywhere(random), anywhere(random)},
                     .light = {static_cast<float>(i % 500), 0, 0},
                     .background = i % 11 == 0});
        if (i % 5 == 0) past.forget(i);
    }
    const auto reprojected = [&](int threads) {
        Reprojection reprojection;
        LiveLayers present;
        present.resize(planeAt({0.3F, 0.1F, -0.2F}, 0.9F * kViewWidth, 2 * kTurnDegree, 20));
        reprojection.reproject(layers, present, threads);
        std::vector<std::uint32_t> all;
        for (std::size_t i = 0; i < present.surface.size(); ++i) {
            all.push_back(present.surface.points[i].state);
            all.push_back(present.surface.known(i) ? present.surface.lights[i].radiance : 0);
        }
        return all;
    };
    const auto wanted = reprojected(1);
    for (const std::string& set : instructionSets()) {
        ASSERT_TRUE(useInstructionSet(set));
        for (const int threads : {1, 3}) EXPECT_EQ(reprojected(threads), wanted) << set << ", " << threads;
    }
    useInstructionSet("auto");
}

} // namespace
} // namespace rtcore
