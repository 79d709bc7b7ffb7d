// Glass that is closed but for rounding, as exporters write it: each triangle has corners of its own.
#include "rtcore/scene/closed_surfaces.h"

#include "support/random_numbers.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <functional>

namespace rtcore {
namespace {

using test::SceneBuilder;

/// As modellers compute a ball: by angle, so that the seam and the poles are met twice, by rounding apart.
/// `shape(u, v)` for u and v from 0 to 1.
void patch(SceneBuilder& b, int across, int down, std::uint32_t material,
           const std::function<Vec3(double, double)>& shape) {
    for (int i = 0; i < across; ++i) {
        for (int k = 0; k < down; ++k) {
            const auto at = [&](int di, int dk) {
                return shape(static_cast<double>(i + di) / across, static_cast<double>(k + dk) / down);
            };
            b.triangle(at(0, 0), at(0, 1), at(1, 1), material);
            b.triangle(at(0, 0), at(1, 1), at(1, 0), material);
        }
    }
}

/// Ends of the seam differ by `noise` in each coordinate.
std::function<Vec3(double, double)> ballOf(double radius, double noise, Vec3 centre = {}) {
    return [=](double u, double v) {
        const double turn = 2 * test::kPi * u, polar = test::kPi * v, off = u >= 1 ? noise : 0;
        return centre + Vec3{static_cast<float>(radius * std::cos(turn) * std::sin(polar) + off),
                             static_cast<float>(radius * std::cos(polar) + off),
                             static_cast<float>(-radius * std::sin(turn) * std::sin(polar) - off)};
    };
}

std::size_t openOf(SceneBuilder& b) {
    const Scene scene = b.finish();
    return static_cast<std::size_t>(std::count(scene.closed->begin(), scene.closed->end(), 0));
}

std::size_t openInBall(double radius, double noise, Vec3 centre = {}) {
    SceneBuilder b;
    patch(b, 32, 16, b.material(test::glass()), ballOf(radius, noise, centre));
    return openOf(b);
}

TEST(NearlyClosed, SeamsAndPolesOfABall) {
    for (const double radius : {1e-3, 1.0, 4e3}) {
        EXPECT_EQ(openInBall(radius, 0), 0U) << radius;
        EXPECT_EQ(openInBall(radius, 0.9e-6 * radius), 0U) << radius;
        EXPECT_GT(openInBall(radius, 2e-5 * radius), 0U) << radius << ": no rounding";
    }
}

/// The cells of the weld lie anywhere.
TEST(NearlyClosed, AnywhereInSpace) {
    test::Random random(3);
    for (int i = 0; i < 60; ++i) {
        const float reach = std::pow(10.0F, random.number(-2, 4));
        EXPECT_EQ(openInBall(1, random.number(-1, 1) * 1e-6, random.vector(reach)), 0U) << reach;
    }
}

/// `%.6f`, as OBJ files have it, and a coordinate of the seam that is rounded up here and down there.
TEST(NearlyClosed, SixDigits) {
    SceneBuilder b;
    const auto exact = ballOf(2, 4e-7);
    patch(b, 48, 24, b.material(test::glass()), [&](double u, double v) {
        Vec3 p = exact(u, v);
        for (int axis = 0; axis < 3; ++axis) p[axis] = std::round(p[axis] * 1e6F) / 1e6F;
        return p;
    });
    EXPECT_EQ(openOf(b), 0U);
}

/// Lids that are meshes of their own.
TEST(NearlyClosed, ACylinderWithLids) {
    for (const double noise : {0.0, 5e-7}) {
        SceneBuilder b;
        const auto glass = b.material(test::glass());
        const auto rim = [](double u, double height, double radius) {
            return Vec3{static_cast<float>(radius * std::cos(2 * test::kPi * u)), static_cast<float>(height),
                        static_cast<float>(-radius * std::sin(2 * test::kPi * u))};
        };
        patch(b, 40, 3, glass, [&](double u, double v) { return rim(u, 1 - v, 1); });
        patch(b, 40, 1, glass, [&](double u, double v) { return rim(u, 1 + noise, v); });
        patch(b, 40, 1, glass, [&](double u, double v) { return rim(-u, noise, v); });
        EXPECT_EQ(openOf(b), 0U) << noise;
    }
}

/// Every corner of every triangle is off by itself.
TEST(NearlyClosed, ASoupOfTriangles) {
    test::Random random(5);
    SceneBuilder b;
    const auto exact = ballOf(1, 0);
    patch(b, 24, 12, b.material(test::glass()),
          [&](double u, double v) { return exact(u, v) + random.vector(4e-7F); });
    EXPECT_EQ(openOf(b), 0U);
}

TEST(NearlyClosed, ASmallPartBesideALargeOneHasItsOwnMeasure) {
    SceneBuilder b;
    const auto glass = b.material(test::glass());
    patch(b, 32, 16, glass, ballOf(0.01, 5e-9));
    const std::size_t small = b.buffers.triangles.size();
    patch(b, 32, 16, glass, ballOf(100, 5e-5, {0, 150, 0}));
    patch(b, 32, 16, glass, ballOf(0.01, 1e-6, {0, 1, 0})); // of the large one it would be rounding
    const Scene scene = b.finish();
    EXPECT_EQ(std::count(scene.closed->begin(), scene.closed->begin() + static_cast<long>(2 * small), 0), 0);
    EXPECT_GT(std::count(scene.closed->begin() + static_cast<long>(2 * small), scene.closed->end(), 0), 0);
}

TEST(NearlyClosed, TwoSheetsBackToBackAreWalls) {
    for (const float gap : {1e-8F, 5e-7F}) {
        SceneBuilder b;
        const auto glass = b.material(test::glass());
        b.square({0, 0, gap}, {0, 0, 1}, 1, glass);
        b.square({0, 0, 0}, {0, 0, -1}, 1, glass);
        EXPECT_EQ(openOf(b), 4U) << gap;
    }
}

/// Edges that join two triangles as they are stay as they are: those of a box whose lid is off by rounding
/// alone, but where the lid begins.
TEST(NearlyClosed, WhatIsGluedOnOpensASolidAtItsSeamAlone) {
    constexpr float kOff = 2e-7F;
    int solids = 0;
    for (int axis = 0; axis < 3; ++axis) {
        for (int edge = 0; edge < 4; ++edge) {
            SceneBuilder b;
            const auto glass = b.material(test::glass());
            b.box({0, 0, 0}, {1, 1, 1}, glass, 5);
            b.quad({0, 0, 1 + kOff}, {1, 0, 1 + kOff}, {1, 1, 1 + kOff}, {0, 1, 1 + kOff}, glass);
            Vec3 from{kOff, kOff, kOff}, out{0, 0, 0};
            for (int side = 0; side < 2; ++side) {
                const bool high = (edge >> side & 1) != 0;
                from[(axis + 1 + side) % 3] += high ? 1 : 0;
                out[(axis + 1 + side) % 3] = high ? 1 : -1;
            }
            Vec3 to = from;
            to[axis] += 1;
            b.triangle(from, to, from + out, glass);
            const std::size_t open = openOf(b);
            EXPECT_TRUE(open == 1 || open == 13) << axis << ' ' << edge;
            solids += open == 1 ? 1 : 0;
        }
    }
    EXPECT_EQ(solids, 8);
}

/// Also triangles without area that share no corner with it belong to a ball.
TEST(OpenGlass, IsNoTriangleWithoutArea) {
    SceneBuilder b;
    const auto glass = b.material(test::glass());
    const auto ball = ballOf(1, 1e-7);
    patch(b, 32, 16, glass, ball);
    const Vec3 there = ball(1, 0.5), off{1e-7F, 0, 0};
    b.triangle(there + off, there + off, ball(1, 0.75), glass);
    b.buffers.triangles.back().v[1] = b.buffers.triangles.back().v[0];
    EXPECT_EQ(openOf(b), 0U);
}

TEST(NearlyClosed, LeavesWithHolesStayAsTheyAre) {
    SceneBuilder b;
    Material leaf = test::matte(1);
    leaf.alphaTexture = b.texture(1, 1, {{9, 9, 9, 9}});
    patch(b, 32, 16, b.material(leaf), ballOf(1, 1e-7));
    EXPECT_EQ(openOf(b), std::size_t{2 * 32 * 16});
}

/// A ball of glass as three.js writes it (sines of 180 and 360 degrees are 1e-16, not 0) turns what is behind
/// it round: right of its middle a wall of radiance 1.
TEST(NearlyClosed, ABallTurnsTheWallBehindItRound) {
    SceneBuilder b;
    patch(b, 32, 16, b.material(test::glass()), ballOf(1, 1e-16));
    b.quad({0, -6, -3}, {6, -6, -3}, {6, 6, -3}, {0, 6, -3}, b.material(test::emitter({1, 1, 1})));
    const test::TracedScene scene(b.finish());
    for (const float y : {-0.2F, 0.1F, 0.3F}) {
        EXPECT_NEAR(scene.see({0, 0, 6}, {-0.3F, y, 0}), 0.921, 0.01) << y;
        EXPECT_LT(scene.see({0, 0, 6}, {0.3F, y, 0}), 0.05) << y;
    }
}

TEST(OpenGlass, IsToldByPartWithItsEdges) {
    SceneBuilder b;
    const auto glass = b.material(test::glass());
    const auto part = [&](const char* name, const auto& make) {
        const auto first = static_cast<std::uint32_t>(b.buffers.triangles.size());
        make();
        b.buffers.parts.push_back(
            {b.buffers.addName(name), first, static_cast<std::uint32_t>(b.buffers.triangles.size()) - first});
    };
    part("ball", [&] { patch(b, 32, 16, glass, ballOf(1, 1e-7)); });
    part("box", [&] { b.box({3, 0, 0}, {4, 1, 1}, glass, 5); });
    part("floor", [&] { b.square({0, -2, 0}, {0, 1, 0}, 9, b.material(test::matte(1))); });
    part("pane", [&] { b.square({0, 5, 0}, {0, 1, 0}, 1, glass); });
    const Scene scene = b.finish();
    const std::vector<OpenGlass> expected{{"box", 10, 4}, {"pane", 2, 4}};
    std::vector<OpenGlass> open;
    EXPECT_EQ(*findClosedSurfaces(scene.model, scene.materials, open), *scene.closed);
    EXPECT_EQ(open, expected);
}

/// A glass ball of a tenth of a million triangles takes tens of ms: time is linear, whatever its shape.
TEST(NearlyClosed, ManyPointsInOnePlaceTakeNoLonger) {
    SceneBuilder b;
    const auto glass = b.material(test::glass());
    for (int i = 0; i < 100'000; ++i)
        b.triangle({0, 0, 0}, {1e-9F * static_cast<float>(i % 7), 0, 0}, {1, 1, 1}, glass);
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(openOf(b), 100'000U);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

} // namespace
} // namespace rtcore
