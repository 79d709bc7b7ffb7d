#include "rtcore/io/import/mesh/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace {

using namespace rtcore;

constexpr double kHalfTurn = 3.14159265358979; // radians

double signedArea(const std::vector<Vec3>& p, const Triangle& t) {
    const Vec3 a = p[t.v[0]], b = p[t.v[1]], c = p[t.v[2]];
    return 0.5 * ((double{b.x} - a.x) * (double{c.y} - a.y) - (double{b.y} - a.y) * (double{c.x} - a.x));
}

double polygonArea(const std::vector<Vec3>& p) {
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Vec3 a = p[i], b = p[(i + 1) % p.size()];
        sum += 0.5 * (double{a.x} * b.y - double{b.x} * a.y);
    }
    return sum;
}

/// n - 2 triangles, none turned over, which together have the polygon's area: then none overlap.
void expectSound(const std::vector<Vec3>& polygon, double tolerance = 1e-9) {
    PolygonCutter cutter;
    const auto triangles = cutter.cut(polygon);
    ASSERT_EQ(triangles.size(), polygon.size() - 2);
    double sum = 0;
    for (const Triangle& t : triangles) {
        const double area = signedArea(polygon, t);
        EXPECT_GE(area, 0);
        sum += area;
    }
    EXPECT_NEAR(sum, polygonArea(polygon), tolerance * std::fabs(polygonArea(polygon)));
}

std::vector<Vec3> star(int points, float inner) {
    std::vector<Vec3> p;
    for (int i = 0; i < 2 * points; ++i) {
        const double angle = kHalfTurn * i / points;
        const float r = i % 2 == 0 ? 1.0F : inner;
        p.push_back({r * static_cast<float>(std::cos(angle)), r * static_cast<float>(std::sin(angle)), 0});
    }
    return p;
}

TEST(Polygon, QuadsAreCutFromTheFirstCorner) {
    PolygonCutter cutter;
    const std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const auto triangles = cutter.cut(square);
    ASSERT_EQ(triangles.size(), 2U);
    EXPECT_EQ(triangles[0], (Triangle{{0, 1, 2}}));
}

TEST(Polygon, ConcaveOnes) {
    for (std::size_t turn = 0; turn < 4; ++turn) {
        // An arrow head, begun at each of its corners.
        std::vector<Vec3> arrow{{0, 0, 0}, {2, -1, 0}, {0.5F, 0, 0}, {2, 1, 0}};
        std::rotate(arrow.begin(), arrow.begin() + static_cast<long>(turn), arrow.end());
        expectSound(arrow);
    }
    expectSound({{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 2, 0}, {3, 2, 0}, {3, 3, 0}, {0, 3, 0}});
    for (const float inner : {0.9F, 0.5F, 0.1F, 0.01F}) expectSound(star(20, inner));
}

TEST(Polygon, AThousandCorners) { expectSound(star(500, 1.0F), 1e-6); }

TEST(Polygon, AHundredThousandCornersInNoTime) {
    const auto start = std::chrono::steady_clock::now();
    expectSound(star(50000, 0.7F), 1e-6);
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 3);
}

TEST(Polygon, AnyPlaneAndWinding) {
    // The same L in the planes of other axes, seen from either side: the cross products sum to the Newell
    // normal.
    const std::vector<Vec3> flat{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
    for (int axis = 0; axis < 3; ++axis) {
        for (const bool reversed : {false, true}) {
            std::vector<Vec3> turned;
            for (const Vec3 p : flat) {
                Vec3 q;
                q[(axis + 1) % 3] = p.x;
                q[(axis + 2) % 3] = p.y;
                turned.push_back(q);
            }
            if (reversed) std::reverse(turned.begin(), turned.end());
            PolygonCutter cutter;
            float sum = 0;
            for (const Triangle& t : cutter.cut(turned)) {
                sum += cross(turned[t.v[1]] - turned[t.v[0]], turned[t.v[2]] - turned[t.v[0]])[axis];
            }
            EXPECT_FLOAT_EQ(sum, reversed ? -6.0F : 6.0F);
        }
    }
}

TEST(Polygon, CornersOnAStraightEdgeStayInTrianglesWithArea) {
    const std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}};
    PolygonCutter cutter;
    for (const Triangle& t : cutter.cut(square)) EXPECT_GT(signedArea(square, t), 0);
}

TEST(Polygon, AHoleJoinedByABridge) {
    const std::vector<Vec3> frame{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
                                  {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
    expectSound(frame);
}

TEST(Polygon, NonsenseGivesAsManyTriangles) {
    const float nan = std::nanf("");
    const std::vector<std::vector<Vec3>> nonsense{
        {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}},            // a point
        {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}},            // a line
        {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}},            // crosses itself, no area
        {{0, 0, 0}, {3, 3, 0}, {3, 0, 0}, {0, 2, 0}, {1, 5, 0}}, // crosses itself
        {{0, 0, 0}, {nan, 1, 0}, {1, 0, 0}, {0, 1, 0}},
        {{0, 0, 0}, {1e38F, 1e38F, 0}, {-1e38F, 1e38F, 1e38F}, {3e38F, 0, 0}},
    };
    PolygonCutter cutter;
    for (const auto& polygon : nonsense) EXPECT_EQ(cutter.cut(polygon).size(), polygon.size() - 2);
}

} // namespace
