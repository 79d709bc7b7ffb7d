// Lines that lie on each other, and points in loops, against counting on a fine grid.
#include "rtcore/plans/flat_region.h"
#include "rtcore/plans/line_union.h"
#include "support/random_numbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace {

using namespace rtcore;

double lengthOf(const std::vector<FlatLine>& lines) {
    double sum = 0;
    for (const FlatLine& line : lines) sum += std::hypot(line.b[0] - line.a[0], line.b[1] - line.a[1]);
    return sum;
}

TEST(UnionOfLines, JoinsWhatOverlapsAndTouches) {
    const std::vector<FlatLine> lines = {{{0, 0}, {2, 0}}, {{3, 0}, {1, 0}}, {{3, 0}, {4, 0}},
                                         {{5, 0}, {6, 0}}, {{0, 1}, {2, 1}}, {{0, 0}, {0, 2}}};
    const std::vector<FlatLine> all = unionOfLines(lines, 1e-6);
    EXPECT_EQ(all.size(), 4U) << "0 to 4, 5 to 6, the one above, the upright one";
    EXPECT_NEAR(lengthOf(all), 4 + 1 + 2 + 2, 1e-12);
    EXPECT_TRUE(unionOfLines({{{1, 1}, {1, 1}}}, 1e-6).empty());
}

// Whole numbers on slanted lines: what is covered is counted unit by unit.
TEST(UnionOfLines, CoversWhatTheLinesCover) {
    test::Random random(3);
    for (int round = 0; round < 50; ++round) {
        const double turn = random.number(-3, 3), right = std::cos(turn), up = std::sin(turn);
        std::vector<FlatLine> lines;
        std::vector<bool> covered(4 * 100);
        for (int i = 0; i < 60; ++i) {
            const auto row = static_cast<double>(random.index(4)),
                       from = static_cast<double>(random.index(90));
            const double to = from + 1 + static_cast<double>(random.index(9));
            const auto at = [&](double x) { return FlatPoint{x * right - row * up, x * up + row * right}; };
            lines.push_back(random.coin() ? FlatLine{at(from), at(to)} : FlatLine{at(to), at(from)});
            for (double x = from; x < to; ++x) covered[static_cast<std::size_t>(100 * row + x)] = true;
        }
        const auto wanted = static_cast<double>(std::count(covered.begin(), covered.end(), true));
        EXPECT_NEAR(lengthOf(unionOfLines(lines, 1e-3)), wanted, 1e-6) << "round " << round;
    }
}

TEST(FlatRegion, HasTheAreaOfItsLoops) {
    const FlatRegion ring({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {3, 1}, {3, 3}, {1, 3}}});
    EXPECT_TRUE(ring.contains({0.5, 2}));
    EXPECT_FALSE(ring.contains({2, 2}));
    EXPECT_FALSE(ring.contains({5, 2}));
    EXPECT_FALSE(ring.contains({2, -1}));
    EXPECT_FALSE(FlatRegion(std::vector<FlatLoop>{}).contains({0, 0}));
}

// A star of many corners: inside where the distance from its middle is below that of its outline there.
TEST(FlatRegion, FindsPointsInManySidedLoops) {
    constexpr int kCorners = 2000;
    FlatLoop star;
    const auto radius = [](double angle) { return 2 + std::sin(7 * angle); };
    for (int i = 0; i < kCorners; ++i) {
        const double angle = 2 * M_PI * i / kCorners;
        star.push_back({radius(angle) * std::cos(angle), radius(angle) * std::sin(angle)});
    }
    const FlatRegion region({star});
    test::Random random(5);
    int inside = 0;
    for (int i = 0; i < 20'000; ++i) {
        const double x = random.number(-3, 3), y = random.number(-3, 3), away = std::hypot(x, y);
        const double edge = radius(std::atan2(y, x));
        if (std::fabs(away - edge) < 0.01) continue;
        EXPECT_EQ(region.contains({x, y}), away < edge) << x << ' ' << y;
        inside += away < edge ? 1 : 0;
    }
    EXPECT_GT(inside, 5000);
}

} // namespace
