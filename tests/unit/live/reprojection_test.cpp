#include "rtcore/live/reprojection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace rtcore {
namespace {

constexpr int kWallColumns = 40, kWallRows = 30;
constexpr float kDepth = 10;

ImagePlane planeFrom(Vec3 eye, int width = kWallColumns, int height = kWallRows) {
    Camera camera;
    camera.eye = eye;
    return {CameraRays(camera, width, height), width, height};
}

/// The point of a wall across the view, kDepth before the eye, that is seen at (x, y) in pixels.
Vec3 onWall(const ImagePlane& plane, float x, float y) { return plane.eye + plane.towards(x, y) * kDepth; }

Colour lightOf(int x, int y) { return {static_cast<float>(x), static_cast<float>(y), 1}; }

/// A wall, each pixel with light of its own.
class Wall : public testing::Test {
  protected:
    Wall() {
        past.clear(planeFrom({}));
        for (int y = 0; y < kWallRows; ++y) {
            for (int x = 0; x < kWallColumns; ++x) {
                const Vec3 middle =
                    onWall(past.plane(), static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
                past.set(past.index(x, y), {.position = middle, .light = lightOf(x, y)});
            }
        }
    }
    /// Reprojects to an eye that has moved so many pixels of the wall to the right and down.
    void reprojectTo(float right, float down) {
        const ImagePlane& plane = past.plane();
        now.resize(planeFrom((plane.right * right + plane.down * down) * kDepth));
        reproject();
    }
    void reproject() { reprojection.reproject(layers, now, 1); }
    Colour seen(int x, int y) const { return present.light(present.index(x, y)); }
    bool known(int x, int y) const { return present.known(present.index(x, y)); }
    float staleness(int x, int y) const { return reprojection.staleness()[present.index(x, y)]; }
    int samples() const {
        int count = 0;
        for (std::size_t i = 0; i < present.size(); ++i) count += present.known(i) ? 1 : 0;
        return count;
    }

    LiveLayers layers, now;
    LiveSamples &past = layers.surface, &present = now.surface;
    Reprojection reprojection;
};

TEST_F(Wall, StaysWhereItIsForAnEyeAtRest) {
    reprojectTo(0, 0);
    for (int y = 0; y < kWallRows; ++y) {
        for (int x = 0; x < kWallColumns; ++x) {
            ASSERT_TRUE(known(x, y));
            EXPECT_EQ(seen(x, y), lightOf(x, y));
            EXPECT_LT(staleness(x, y), 1e-4F);
            EXPECT_EQ(present.age(present.index(x, y)), 1);
        }
    }
}

TEST_F(Wall, GoesToTheLeftOfAnEyeThatGoesRight) {
    reprojectTo(3, 1);
    for (int y = 0; y + 1 < kWallRows; ++y) {
        for (int x = 0; x + 3 < kWallColumns; ++x) EXPECT_EQ(seen(x, y), lightOf(x + 3, y + 1));
    }
    for (int y = 0; y < kWallRows; ++y) EXPECT_FALSE(known(kWallColumns - 1, y));
    for (int x = 0; x < kWallColumns; ++x) EXPECT_FALSE(known(x, kWallRows - 1));
}

TEST_F(Wall, IsTheStalerTheFurtherItsSamplesAreFromTheMiddles) {
    reprojectTo(0.25F, 0);
    EXPECT_NEAR(staleness(20, 15), 0.25F * 0.25F, 1e-3);
    reprojectTo(0.375F, 0.125F);
    EXPECT_NEAR(staleness(20, 15), 0.375F * 0.375F + 0.125F * 0.125F, 1e-3);
}

TEST_F(Wall, AgesFasterWhereItsLightWanders) {
    const std::size_t mirror = past.index(20, 15);
    past.set(mirror, {.position = past.points[mirror].position, .unreliable = true});
    reprojectTo(0, 0);
    std::swap(layers, now);
    reprojectTo(0, 0);
    EXPECT_GT(staleness(21, 15), 0);
    EXPECT_GT(staleness(20, 15), 20 * staleness(21, 15));
}

TEST_F(Wall, HidesWhatIsBehindIt) {
    const std::size_t corner = past.index(0, 0);
    const Vec3 behind = past.plane().eye + past.plane().towards(20.5F, 15.5F) * (2 * kDepth);
    past.set(corner, {.position = behind, .light = {500, 0, 0}});
    reprojectTo(0, 0);
    EXPECT_EQ(seen(20, 15), lightOf(20, 15));
    for (std::size_t i = 0; i < present.size(); ++i) EXPECT_LT(present.light(i).r, 400);
    const Vec3 before = past.plane().eye + past.plane().towards(20.5F, 15.5F) * (0.5F * kDepth);
    past.set(corner, {.position = before, .light = {500, 0, 0}});
    reprojectTo(0, 0);
    EXPECT_GT(seen(20, 15).r, 400);
}

TEST_F(Wall, KeepsBothOfTwoSamplesInAPixelWhereThatBesideHasNone) {
    const Vec3 toTheRight = onWall(past.plane(), 20.9F, 15.5F); // of the pixel (20, 15)
    past.set(past.index(21, 15), {.position = toTheRight, .light = {300, 0, 0}});
    reprojectTo(0, 0);
    EXPECT_EQ(seen(20, 15), lightOf(20, 15));
    EXPECT_NEAR(seen(21, 15).r, 300, 1);
    EXPECT_GT(staleness(21, 15), staleness(20, 15));
}

TEST_F(Wall, LendsItsLightToACrack) {
    past.forget(past.index(20, 15));
    reprojectTo(0, 0);
    ASSERT_TRUE(known(20, 15));
    EXPECT_GT(staleness(20, 15), 0.9F);
    const Colour light = seen(20, 15);
    EXPECT_LE(std::fabs(light.r - 20) + std::fabs(light.g - 15), 1.01F);
    for (int y = 14; y <= 17; ++y) {
        for (int x = 19; x <= 22; ++x) past.forget(past.index(x, y));
    }
    reprojectTo(0, 0);
    EXPECT_FALSE(known(20, 15)) << "a hole is no crack";
}

TEST_F(Wall, HidesWhatIsSeenThroughItsGaps) {
    constexpr float kLittle = 0.01F;
    const auto setBehind = [&](int x, int y) {
        const Vec3 towards = past.plane().towards(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
        past.set(past.index(x, y),
                 {.position = past.plane().eye + towards * (2 * kDepth), .light = {500, 0, 0}});
    };
    setBehind(20, 15);
    setBehind(21, 15);
    reprojectTo(0, 0);
    EXPECT_GT(seen(20, 15).r, 400) << "for an eye at rest it is a hole";
    reprojectTo(kLittle, 0);
    EXPECT_LT(seen(20, 15).r, 100);
    EXPECT_LT(seen(21, 15).r, 100);
    EXPECT_GT(staleness(20, 15), 0.9F);
    for (int y = 0; y < kWallRows; ++y) setBehind(10, y);
    for (int y = 20; y < 24; ++y) {
        for (int x = 30; x < 35; ++x) setBehind(x, y);
    }
    reprojectTo(kLittle, 0);
    for (int y = 0; y < kWallRows; ++y) EXPECT_GT(seen(10, y).r, 400) << "a slit is no gap";
    EXPECT_GT(seen(32, 22).r, 400) << "nor is a hole";
}

TEST_F(Wall, HasNoMoreSamplesThanWereThere) {
    reprojectTo(0, 0);
    EXPECT_EQ(samples(), kWallColumns * kWallRows);
    past.clear(past.plane());
    reprojectTo(0, 0);
    EXPECT_EQ(samples(), 0);
    past.clear({});
    reprojectTo(0, 0);
    EXPECT_EQ(samples(), 0);
}

TEST_F(Wall, IsSeenInImagesOfAnotherSize) {
    present.resize(planeFrom({}, kWallColumns / 2, kWallRows / 2));
    reproject();
    EXPECT_EQ(samples(), kWallColumns / 2 * kWallRows / 2);
    EXPECT_NEAR(seen(10, 7).r, 20.5F, 1.01F);
}

TEST_F(Wall, BehindTheEyeIsNotSeen) {
    present.resize(planeFrom(past.plane().towards(kWallColumns * 0.5F, kWallRows * 0.5F) * (1.5F * kDepth)));
    reproject();
    EXPECT_EQ(samples(), 0);
}

TEST_F(Wall, TheBackgroundStaysWhileTheEyeMoves) {
    for (std::size_t i = 0; i < past.size(); ++i) {
        const int x = static_cast<int>(i) % kWallColumns, y = static_cast<int>(i) / kWallColumns;
        past.set(
            i, {.position = past.plane().towards(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F),
                .light = lightOf(x, y),
                .background = true});
    }
    reprojectTo(7, 3);
    EXPECT_EQ(seen(20, 15), lightOf(20, 15));
    EXPECT_LT(staleness(20, 15), 0.01F);
}

TEST_F(Wall, AgesToALimit) {
    for (int i = 0; i < 300; ++i) {
        reprojectTo(0, 0);
        std::swap(layers, now);
    }
    EXPECT_EQ(past.age(past.index(20, 15)), 255);
    EXPECT_EQ(past.points[past.index(20, 15)].state >> 8, LiveSamples::kKnown >> 8);
}

TEST_F(Wall, ShowsWhatItMirrorsWhereThatSeemsToBe) {
    layers.mirrors = now.mirrors = true;
    layers.resizeSpecular(past.plane());
    for (int y = 0; y < kWallRows; ++y) {
        for (int x = 0; x < kWallColumns; ++x) {
            const std::size_t i = past.index(x, y);
            const Vec3 behind = past.points[i].position * 2; // of an eye in the origin
            past.set(i, {.position = past.points[i].position, .light = lightOf(x, y), .mirrors = x < 30});
            layers.specular.set(i, {.position = behind, .light = lightOf(x, y)});
        }
    }
    const ImagePlane& plane = past.plane();
    now.resize(planeFrom(plane.right * (4 * kDepth)));
    reproject();
    EXPECT_EQ(seen(20, 15), lightOf(24, 15));
    EXPECT_EQ(now.specular.light(present.index(20, 15)), lightOf(22, 15)) << "twice as far, half as fast";
    EXPECT_TRUE(now.known(present.index(20, 15)));
    EXPECT_FALSE(present.mirrors(present.index(28, 15)));
    EXPECT_FALSE(now.specular.known(present.index(28, 15))) << "no mirror is there any more";
}

TEST_F(Wall, KeepsWhatIsMirroredWhereTheMirrorIsNotKnownYet) {
    layers.mirrors = now.mirrors = true;
    layers.resizeSpecular(past.plane());
    for (std::size_t i = 0; i < past.size(); ++i) {
        const Vec3 behind = past.points[i].position * 2; // of an eye in the origin
        layers.specular.set(i, {.position = behind, .light = past.light(i)});
        past.forget(i);
    }
    const ImagePlane& plane = past.plane();
    now.resize(planeFrom(plane.right * (4 * kDepth)));
    reproject();
    EXPECT_EQ(samples(), 0);
    EXPECT_EQ(now.specular.light(present.index(20, 15)), lightOf(22, 15));
    EXPECT_FALSE(now.known(present.index(20, 15)));
}

TEST(Reprojection, IsOfImagesOfOneRowOrColumn) {
    for (const auto& [width, height] : {std::pair(300, 1), std::pair(1, 300), std::pair(1, 1)}) {
        LiveLayers past, present;
        past.resize(planeFrom({}, width, height));
        for (std::size_t i = 0; i < past.surface.size(); ++i) {
            // All in one pixel of each, so that each of them loses it.
            const ImagePlane& plane = past.surface.plane();
            const auto across = static_cast<float>(width) - 0.3F, down = static_cast<float>(height) - 0.4F;
            past.surface.set(i, {.position = onWall(plane, across, down), .light = {1, 1, 1}});
        }
        present.resize(past.surface.plane());
        Reprojection reprojection;
        reprojection.reproject(past, present, 2);
        EXPECT_TRUE(present.surface.known(present.surface.size() - 1));
    }
}

TEST(Reprojection, IsTheSameForAnyNumberOfThreads) {
    constexpr int kManyColumns = 150, kManyRows = 130;
    LiveLayers layers;
    layers.mirrors = true;
    LiveSamples& past = layers.surface;
    layers.resize(planeFrom({}, kManyColumns, kManyRows));
    std::mt19937 random(7);
    std::uniform_real_distribution<float> anywhere(-15, 15);
    for (std::size_t i = 0; i < past.size(); ++i) {
        past.set(i, {.position = {anywhere(random), anywhere(random), anywhere(random)},
                     .light = {static_cast<float>(i % 500), 0, 0},
                     .background = i % 11 == 0,
                     .mirrors = i % 3 == 0,
                     .unreliable = i % 7 == 0});
        if (i % 5 == 0) past.forget(i);
        layers.specular.set(i, {.position = {anywhere(random), anywhere(random), anywhere(random)},
                                .light = {static_cast<float>(i % 300), 0, 0}});
        layers.tints[i] = static_cast<std::uint32_t>(i);
    }
    const auto carried = [&](int threads) {
        Reprojection reprojection;
        LiveLayers present;
        present.mirrors = true;
        present.resize(planeFrom({0.3F, 0.1F, -0.2F}, kManyColumns, kManyRows));
        reprojection.reproject(layers, present, threads);
        std::vector<std::uint32_t> all;
        for (std::size_t i = 0; i < present.surface.size(); ++i) {
            all.push_back(present.surface.mirrors(i) ? present.tints[i] : 0);
            for (const LiveSamples* layer : {&present.surface, &present.specular}) {
                all.push_back(layer->points[i].state);
                all.push_back(layer->known(i) ? layer->lights[i].radiance : 0);
            }
        }
        return all;
    };
    const auto one = carried(1);
    for (const int threads : {2, 7}) EXPECT_EQ(carried(threads), one) << threads;
}

} // namespace
} // namespace rtcore
