// The brightest texel of cells of the sphere, and of their neighbours across the edges of the unfolded
// square.
#include "rtcore/lights/brightest_cells.h"

#include "rtcore/math/constants.h"
#include "rtcore/math/octahedron-inl.h"

#include "support/random_numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace rtcore {
namespace brightest_cells {
namespace {

namespace plain = HWY_NAMESPACE;

std::size_t cellOf(Vec3 direction, int side) {
    return static_cast<std::size_t>(plain::octahedronTexel<float>(direction, side));
}

TEST(BrightestCells, HaveTheTexelsInThem) {
    test::Random random(1);
    HdrImage image(64, 32);
    for (Colour& texel : image.pixels) texel = kWhite * random.number(0, 1);
    image.at(17, 9) = kWhite * 50.0F;
    Environment environment = Environment::fromEquirectangular(image, "");
    environment.intensity = 4;
    environment.turn(100, {0, 0, 1});
    for (const int side : {4, 16, 64, 256}) {
        const std::vector<float> cells = brightestInCells(environment, side);
        ASSERT_EQ(cells.size(), static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
        const float polar = (9 + 0.5F) / 32 * kPi, azimuth = (17 + 0.5F) / 32 * kPi - kPi;
        const Vec3 bright = environment.turned({portableSin(polar) * portableSin(azimuth), portableCos(polar),
                                                -portableSin(polar) * portableCos(azimuth)});
        EXPECT_FLOAT_EQ(cells[cellOf(bright, side)], 50);
        EXPECT_LE(*std::max_element(cells.begin(), cells.end()), 50.001F);
        EXPECT_GE(*std::min_element(cells.begin(), cells.end()), 0);
        // Cells that are smaller than texels see the image as it is looked up.
        if (side != 256) continue;
        int nearby = 0;
        for (int i = 0; i < 2000; ++i) {
            const Vec3 d = random.unitVector();
            const float seen = luminance(environment.radiance(d, TexelFilter::Bilinear)) / 4;
            if (std::abs(cells[cellOf(d, side)] - seen) < 0.3F) ++nearby;
        }
        EXPECT_GT(nearby, 1900);
    }
}

TEST(BrightestCells, CountNegativeLightByItsSizeAndNoNumbersAsBlack) {
    const HdrImage image(8, 4, {-1, -1, -1});
    for (const float cell : brightestInCells(Environment::fromEquirectangular(image, ""), 8))
        EXPECT_NEAR(cell, 1, 1e-6F);
    const HdrImage none(8, 4, kWhite * std::numeric_limits<float>::quiet_NaN());
    for (const float cell : brightestInCells(Environment::fromEquirectangular(none, ""), 8))
        EXPECT_EQ(cell, 0);
}

// Whichever way one leaves a cell, the next one knows of it.
TEST(BrightestCells, AreNeighboursAcrossAllEdges) {
    constexpr int kSide = 8;
    test::Random random(2);
    std::vector<float> cells(kSide * kSide);
    for (float& cell : cells) cell = random.number(0, 1);
    const std::vector<float> around = brightestAround(cells, kSide);
    int crossed = 0;
    for (int i = 0; i < 100000; ++i) {
        const Vec3 from = random.unitVector(), to = normalize(from + random.unitVector() * 0.02F);
        const std::size_t a = cellOf(from, kSide), b = cellOf(to, kSide);
        crossed += a != b ? 1 : 0;
        ASSERT_GE(around[b], cells[a]);
        ASSERT_GE(around[a], cells[b]);
    }
    EXPECT_GT(crossed, 1000);
    // And no others: nine cells, some of them the same where an edge is folded.
    for (std::size_t i = 0; i < cells.size(); ++i) {
        std::vector<float> one(cells.size());
        one[i] = 1;
        const std::vector<float> seen = brightestAround(one, kSide);
        const auto count = std::count(seen.begin(), seen.end(), 1.0F);
        EXPECT_TRUE(count >= 7 && count <= 9) << i << ": " << count;
    }
}

} // namespace
} // namespace brightest_cells
} // namespace rtcore
