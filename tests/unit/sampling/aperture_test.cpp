#include "rtcore/sampling/aperture.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rtcore {
namespace {

TEST(OnDisc, TheConcentricMap) {
    const Vec2 p = onDisc({.9F, .6F});
    EXPECT_NEAR(p.x, .784628F, 2e-6F);
    EXPECT_NEAR(p.y, .156072F, 2e-6F);
    EXPECT_EQ(onDisc({.5F, .5F}), (Vec2{0, 0}));
    for (const SquarePoint corner : {SquarePoint{0, 0}, {1, 0}, {0, 1}, {1, 1}, {1, .5F}, {.5F, 0}}) {
        const Vec2 q = onDisc(corner);
        EXPECT_NEAR(std::hypot(q.x, q.y), 1, 1e-6);
    }
}

struct Moments {
    double area = 0;       ///< of what a fine grid of points covers, by their density at each place
    double meanSquare = 0; ///< of the distance from the middle
    double x = 0, y = 0;
};

Moments momentsOf(int corners, int side) {
    Aperture aperture;
    aperture.prepare(corners);
    Moments m;
    const double count = static_cast<double>(side) * side;
    for (int i = 0; i < side; ++i) {
        for (int k = 0; k < side; ++k) {
            const SquarePoint point{(static_cast<float>(i) + .5F) / static_cast<float>(side),
                                    (static_cast<float>(k) + .5F) / static_cast<float>(side)};
            const Vec2 p = aperture.at(point);
            const double x = p.x, y = p.y;
            m.meanSquare += (x * x + y * y) / count;
            m.x += x / count;
            m.y += y / count;
        }
    }
    return m;
}

TEST(Aperture, PolygonsAreFilledEvenly) {
    EXPECT_NEAR(momentsOf(6, 300).meanSquare, .416667, 1e-4);
    for (const int corners : {3, 4, 5, 6, 7, 8, 32}) {
        const Moments m = momentsOf(corners, 420);
        EXPECT_NEAR(m.meanSquare, (2 + std::cos(2 * 3.14159265358979 / corners)) / 6, 5e-4) << corners;
        EXPECT_NEAR(m.x, 0, 1e-3);
        EXPECT_NEAR(m.y, 0, 1e-3);
    }
}

TEST(Aperture, BelowThreeCornersItIsRound) {
    for (const int corners : {0, 1, 2}) EXPECT_NEAR(momentsOf(corners, 300).meanSquare, .5, 1e-4);
}

TEST(Aperture, AHexagonReachesItsCornersAndNotFurther) {
    Aperture aperture;
    aperture.prepare(6);
    double inside = 0, largest = 0;
    constexpr int kSide = 400;
    for (int i = 0; i < kSide * kSide; ++i) {
        const Vec2 p =
            aperture.at({static_cast<float>(i % kSide) / kSide, static_cast<float>(i / kSide) / kSide});
        largest = std::max(largest, static_cast<double>(std::hypot(p.x, p.y)));
        if (std::hypot(p.x, p.y) < .5F) ++inside;
    }
    EXPECT_GT(largest, .99);
    EXPECT_LE(largest, 1.000001);
    // The share of a disc of radius 1/2 in the hexagon's area.
    EXPECT_NEAR(inside / (kSide * kSide), 3.14159265358979 / 4 / 2.598076, 2e-3);
}

} // namespace
} // namespace rtcore
