#include "rtcore/accel/triangle_clip.h"

#include "support/random_numbers.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <vector>

using rtcore::Box3;
using rtcore::Vec3;

namespace {

using Corners = std::array<Vec3, 3>;
using Point = std::array<double, 3>;

constexpr Box3 kCell{{-1, -1, -1}, {1, 1, 1}};

Box3 boundsOf(const Corners& corners) {
    Box3 box;
    for (const Vec3 p : corners) box.extend(p);
    return box;
}

bool within(const Box3& inner, const Box3& outer) {
    for (int a = 0; a < 3; ++a) {
        if (inner.lo[a] < outer.lo[a] || inner.hi[a] > outer.hi[a]) return false;
    }
    return true;
}

/// Bounds of the points of a dense grid over the triangle that lie in the cell.
struct Sampled {
    Point lo{1e30, 1e30, 1e30}, hi{-1e30, -1e30, -1e30};
    bool any = false;
};

Sampled sample(const Corners& corners, const Box3& cell, double margin, int steps) {
    Sampled s;
    for (int i = 0; i <= steps; ++i) {
        for (int j = 0; i + j <= steps; ++j) {
            const double u = static_cast<double>(i) / steps;
            const double v = static_cast<double>(j) / steps;
            Point p{};
            bool inside = true;
            for (int a = 0; a < 3; ++a) {
                double& x = p[static_cast<std::size_t>(a)];
                x = (1 - u - v) * corners[0][a] + u * corners[1][a] + v * corners[2][a];
                inside = inside && x >= cell.lo[a] - margin && x <= cell.hi[a] + margin;
            }
            if (!inside) continue;
            s.any = true;
            for (std::size_t a = 0; a < 3; ++a) {
                s.lo[a] = std::min(s.lo[a], p[a]);
                s.hi[a] = std::max(s.hi[a], p[a]);
            }
        }
    }
    return s;
}

/// Whatever the triangle, the result holds all sampled points, and reaches beyond neither triangle nor cell.
void expectSound(const Corners& corners, const Box3& cell, float margin) {
    const Box3 box = rtcore::clippedBounds(corners, cell, margin);
    const Sampled s = sample(corners, cell, 0, 60);
    if (box.empty()) {
        EXPECT_FALSE(s.any);
        return;
    }
    EXPECT_TRUE(within(box, cell));
    const Box3 own = boundsOf(corners);
    for (int a = 0; a < 3; ++a) {
        // Beyond the triangle only where the margin alone brought it into the cell.
        EXPECT_TRUE(box.lo[a] >= own.lo[a] || own.hi[a] < cell.lo[a]);
        EXPECT_TRUE(box.hi[a] <= own.hi[a] || own.lo[a] > cell.hi[a]);
        if (!s.any) continue;
        const auto i = static_cast<std::size_t>(a);
        EXPECT_LE(box.lo[a], s.lo[i] + 1e-12 * std::fabs(s.lo[i]));
        EXPECT_GE(box.hi[a], s.hi[i] - 1e-12 * std::fabs(s.hi[i]));
    }
}

} // namespace

TEST(ClippedBounds, HoldTheSampledTriangle) {
    test::Random random(6);
    const float margin = rtcore::clipMargin({{-2, -2, -2}, {2, 2, 2}});
    for (int round = 0; round < 1500; ++round) {
        const Corners corners{random.vector(2), random.vector(2), random.vector(2)};
        expectSound(corners, kCell, margin);
        expectSound(corners, kCell, 0);
    }
}

TEST(ClippedBounds, HoldSliversAndPoints) {
    test::Random random(7);
    const float margin = rtcore::clipMargin({{-2, -2, -2}, {2, 2, 2}});
    for (int round = 0; round < 1000; ++round) {
        const Vec3 a = random.vector(2);
        const Vec3 b = random.vector(2);
        expectSound({a, b, b + random.vector(1e-6F)}, kCell, margin);
        expectSound({a, b, a * 0.5F + b * 0.5F}, kCell, margin);
        expectSound({a, a, b}, kCell, margin);
        expectSound({a, a, a}, kCell, margin);
    }
}

TEST(ClippedBounds, AreTight) {
    test::Random random(8);
    for (int round = 0; round < 300; ++round) {
        const Corners corners{random.vector(2), random.vector(2), random.vector(2)};
        const Box3 box = rtcore::clippedBounds(corners, kCell, 0);
        // No larger than the samples by more than the distance between two of them.
        constexpr int steps = 300;
        const Sampled s = sample(corners, kCell, 8.0 / steps, steps);
        if (box.empty()) continue;
        ASSERT_TRUE(s.any);
        for (int a = 0; a < 3; ++a) {
            const auto i = static_cast<std::size_t>(a);
            EXPECT_GE(box.lo[a], s.lo[i] - 8.0 / steps);
            EXPECT_LE(box.hi[a], s.hi[i] + 8.0 / steps);
        }
    }
}

TEST(ClippedBounds, OfATriangleInsideAreItsOwn) {
    test::Random random(9);
    for (int round = 0; round < 100; ++round) {
        const Corners corners{random.vector(1), random.vector(1), random.vector(1)};
        EXPECT_EQ(rtcore::clippedBounds(corners, kCell, 1e-6F), boundsOf(corners));
    }
}

TEST(ClippedBounds, KnownCut) {
    // In the plane z = 0; the cell cuts off the two corners at x = -3 and x = 3.
    const Corners corners{Vec3{-3, 0, 0}, {3, 0, 0}, {0, 3, 0}};
    const Box3 box = rtcore::clippedBounds(corners, {{-1, -1, -1}, {1, 9, 1}}, 0);
    EXPECT_EQ(box, (Box3{{-1, 0, 0}, {1, 3, 0}}));
    const Box3 side = rtcore::clippedBounds(corners, {{2, -1, -1}, {9, 9, 1}}, 0);
    EXPECT_EQ(side, (Box3{{2, 0, 0}, {3, 1, 0}}));
}

TEST(ClippedBounds, AreWidenedByTheMargin) {
    const Corners corners{Vec3{-3, 0, 0}, {3, 0, 0}, {0, 3, 0}};
    const float margin = 1.0F / 64;
    const Box3 box = rtcore::clippedBounds(corners, {{2, -1, -1}, {9, 9, 1}}, margin);
    EXPECT_FLOAT_EQ(box.hi.y, 1 + 2 * margin);
    EXPECT_EQ(box.lo.x, 2); // never beyond the cell
    EXPECT_EQ(box.lo.y, 0); // never beyond the triangle
    EXPECT_EQ(box.hi.x, 3);
}

TEST(ClippedBounds, AxisParallelTrianglesStayFlat) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const float height : {-1.0F, -0.25F, 0.0F, 1.0F}) {
            Corners corners;
            const std::array<std::array<float, 2>, 3> flat{{{-5, -5}, {5, -5}, {0, 5}}};
            for (std::size_t i = 0; i < 3; ++i) {
                corners[i][axis] = height;
                corners[i][(axis + 1) % 3] = flat[i][0];
                corners[i][(axis + 2) % 3] = flat[i][1];
            }
            const Box3 box = rtcore::clippedBounds(corners, kCell, 1e-5F);
            ASSERT_FALSE(box.empty());
            EXPECT_EQ(box.lo[axis], height);
            EXPECT_EQ(box.hi[axis], height);
        }
    }
}

TEST(ClippedBounds, TouchingCountsAsInside) {
    // A corner on a face, on an edge, on a corner of the cell.
    for (const Vec3 touch : {Vec3{1, 0.2F, -0.3F}, Vec3{1, 1, 0.4F}, Vec3{1, 1, 1}}) {
        const Corners corners{touch, touch + Vec3{1, 0.5F, 0}, touch + Vec3{1, 0, 0.5F}};
        const Box3 box = rtcore::clippedBounds(corners, kCell, 0);
        EXPECT_EQ(box, (Box3{touch, touch}));
    }
}

TEST(ClippedBounds, OfWhatIsOutsideAreEmpty) {
    EXPECT_TRUE(rtcore::clippedBounds({Vec3{2, 0, 0}, {3, 0, 0}, {2, 1, 0}}, kCell, 1e-6F).empty());
    // Its box overlaps the cell, the triangle does not.
    EXPECT_TRUE(rtcore::clippedBounds({Vec3{0, 3, 0}, {3, 0, 0}, {3, 3, 0}}, kCell, 1e-6F).empty());
}

TEST(ClippedBounds, WhatOnlyTheMarginBringsInTouchesTheFace) {
    const float margin = 1.0F / 1024;
    const float outside = 1 + margin / 2;
    const Corners corners{Vec3{outside, 0, 0}, {outside + 1, 0, 0}, {outside, 0.5F, 0}};
    const Box3 box = rtcore::clippedBounds(corners, kCell, margin);
    ASSERT_FALSE(box.empty());
    EXPECT_EQ(box.lo.x, 1);
    EXPECT_EQ(box.hi.x, 1);
}

TEST(ClipMargin, GrowsWithTheLargestCoordinate) {
    EXPECT_EQ(rtcore::clipMargin({{-1, 0, 0}, {0.5F, 1, 1}}), 0x1p-21F);
    EXPECT_EQ(rtcore::clipMargin({{0, -1024, 0}, {1, 1, 1}}), 0x1p-11F);
    EXPECT_EQ(rtcore::clipMargin({{0, 0, 0}, {0, 0, 0}}), 0);
}
