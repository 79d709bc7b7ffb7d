// Areas in pixels: exact, whatever lies outside of the image, and as often as loops wind.
#include "rtcore/sections/coverage.h"
#include "support/random_numbers.h"
#include "windings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace {

using rtcore::Coverage;
using rtcore::FlatLoop;
using test::windings;

constexpr int kColumns = 12, kRows = 9;

std::vector<float> partsOf(Coverage& coverage) {
    std::vector<float> parts(std::size_t{kColumns} * kRows);
    coverage.take([&](int x, int y, float part) {
        ASSERT_TRUE(x >= 0 && x < kColumns && y >= 0 && y < kRows);
        parts[static_cast<std::size_t>(y * kColumns + x)] = part;
    });
    return parts;
}

double sumOf(const std::vector<float>& parts) {
    double sum = 0;
    for (const float part : parts) sum += static_cast<double>(part);
    return sum;
}

FlatLoop rectangle(double left, double top, double right, double bottom) {
    return {{left, top}, {left, bottom}, {right, bottom}, {right, top}};
}

TEST(Coverage, IsExactForRectangles) {
    Coverage coverage(kColumns, kRows);
    coverage.add(rectangle(1.25, 2.5, 4.5, 3.75));
    const std::vector<float> parts = partsOf(coverage);
    EXPECT_NEAR(sumOf(parts), 3.25 * 1.25, 1e-5);
    EXPECT_NEAR(parts[2 * kColumns + 1], 0.75 * 0.5, 1e-6);
    EXPECT_NEAR(parts[3 * kColumns + 4], 0.5 * 0.75, 1e-6);
    EXPECT_EQ(parts[4 * kColumns + 2], 0);
    EXPECT_EQ(sumOf(partsOf(coverage)), 0) << "it begins anew";
}

TEST(Coverage, CountsWhatLiesInTheImage) {
    Coverage coverage(kColumns, kRows);
    coverage.add(rectangle(-1e7, -50, 3, 1e9));
    EXPECT_NEAR(sumOf(partsOf(coverage)), 3 * kRows, 1e-3);
    coverage.add(rectangle(-1e7, -1e7, 1e7, 1e7));
    EXPECT_NEAR(sumOf(partsOf(coverage)), kColumns * kRows, 1e-3);
    for (const FlatLoop& outside : {rectangle(-9, 1, -2, 5), rectangle(kColumns, 1, kColumns + 4, 5),
                                    rectangle(1, -9, 5, 0), rectangle(1, kRows, 5, kRows + 3)}) {
        coverage.add(outside);
        EXPECT_EQ(sumOf(partsOf(coverage)), 0);
    }
    coverage.add(FlatLoop{{1, 1}, {NAN, 3}, {4, 1}});
    EXPECT_EQ(sumOf(partsOf(coverage)), 0) << "no number";
}

TEST(Coverage, IsOnceWhereLoopsOverlapAndNoneInAHole) {
    Coverage coverage(kColumns, kRows);
    coverage.add(rectangle(1, 1, 5, 5));
    coverage.add(rectangle(3, 3, 8, 8));
    EXPECT_NEAR(sumOf(partsOf(coverage)), 16 + 25 - 4, 1e-5);
    FlatLoop hole = rectangle(2.5, 2.5, 4, 4);
    std::ranges::reverse(hole);
    coverage.add(rectangle(1, 1, 6, 6));
    coverage.add(hole);
    EXPECT_NEAR(sumOf(partsOf(coverage)), 25 - 2.25, 1e-5);
}

TEST(Coverage, OfTrianglesIsThatOfManySamples) {
    constexpr int kSamples = 40;
    test::Random random(7);
    Coverage coverage(kColumns, kRows);
    for (int round = 0; round < 60; ++round) {
        FlatLoop loop;
        for (int i = 0; i < 3; ++i)
            loop.push_back({double{random.number(-6, 18)}, double{random.number(-6, 15)}});
        coverage.add(loop);
        const std::vector<float> parts = partsOf(coverage);
        for (int y = 0; y < kRows; ++y) {
            for (int x = 0; x < kColumns; ++x) {
                int inside = 0;
                for (int s = 0; s < kSamples * kSamples; ++s)
                    inside += windings(loop, {x + (s % kSamples + 0.5) / kSamples,
                                              y + (s / kSamples + 0.5) / kSamples}) != 0;
                ASSERT_NEAR(parts[static_cast<std::size_t>(y * kColumns + x)],
                            inside / double{kSamples * kSamples}, 0.03)
                    << round << ": " << x << ", " << y;
            }
        }
    }
}

} // namespace
