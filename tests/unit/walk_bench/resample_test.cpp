// Images in other pixels: means over squares that may cut pixels, and what lies between pixels.
#include "bench/walk/resample.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using bench::averagedDown, bench::interpolated;
using rtcore::Colour;
using rtcore::HdrImage;

/// Red grows by 1 from column to column, green from row to row; blue is 3.
HdrImage ramps(int width, int height) {
    HdrImage image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) image.at(x, y) = {static_cast<float>(x), static_cast<float>(y), 3};
    }
    return image;
}

void expectNear(Colour a, Colour b) {
    EXPECT_NEAR(a.r, b.r, 1e-5F);
    EXPECT_NEAR(a.g, b.g, 1e-5F);
    EXPECT_NEAR(a.b, b.b, 1e-5F);
}

TEST(AreaAverage, KeepsAnImageOfThatSize) {
    const HdrImage image = ramps(5, 4);
    EXPECT_EQ(averagedDown(image, 5, 4).pixels, image.pixels);
}

TEST(AreaAverage, IsTheMeanOfWholePixels) {
    const HdrImage image = averagedDown(ramps(8, 6), 4, 3);
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 4; ++x)
            expectNear(image.at(x, y),
                       {2 * static_cast<float>(x) + 0.5F, 2 * static_cast<float>(y) + 0.5F, 3});
    }
}

// One row is over: half of it is cut off above and below, and squares have halves of the rows at their edges.
TEST(AreaAverage, KeepsTheMiddle) {
    const HdrImage image = averagedDown(ramps(8, 5), 4, 2);
    expectNear(image.at(0, 0), {0.5F, 1, 3});
    expectNear(image.at(3, 1), {6.5F, 3, 3});
}

TEST(AreaAverage, CutsPixels) {
    const HdrImage image = averagedDown(ramps(3, 3), 2, 2);
    expectNear(image.at(0, 0), {1.0F / 3, 1.0F / 3, 3});
    expectNear(image.at(1, 1), {5.0F / 3, 5.0F / 3, 3});
}

// Squares that reach beyond the upper and lower edge count for what they have inside.
TEST(AreaAverage, CutsSquaresAtTheEdge) {
    const HdrImage image = averagedDown(ramps(4, 3), 2, 2);
    expectNear(image.at(0, 0), {0.5F, 1.0F / 3, 3});
    expectNear(image.at(1, 1), {2.5F, 5.0F / 3, 3});
}

TEST(Interpolation, KeepsAnImageOfThatSize) {
    const HdrImage image = ramps(5, 4);
    EXPECT_EQ(interpolated(image, 5, 4).pixels, image.pixels);
    EXPECT_EQ(interpolated(ramps(1, 1), 3, 2).pixels, HdrImage(3, 2, {0, 0, 3}).pixels);
}

TEST(Interpolation, IsLinearBetweenMiddlesOfPixels) {
    const HdrImage image = interpolated(ramps(3, 2), 6, 4);
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 6; ++x)
            expectNear(image.at(x, y), {std::clamp(0.5F * static_cast<float>(x) - 0.25F, 0.0F, 2.0F),
                                        std::clamp(0.5F * static_cast<float>(y) - 0.25F, 0.0F, 1.0F), 3});
    }
}

} // namespace
