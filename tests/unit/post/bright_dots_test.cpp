// A dot that one half alone saw is taken from what a net sees; what both saw stays.
#include "rtcore/post/bright_dots.h"

#include <gtest/gtest.h>

namespace rtcore {
namespace {

constexpr int kDotsSide = 9;

HdrImage evenImage() { return {kDotsSide, kDotsSide, kWhite * 0.5F}; }

TEST(BrightDots, ThatOneHalfSawAreTaken) {
    HdrImage half = evenImage(), input;
    half.at(4, 4) = {30, 60, 15};
    half.at(0, 8) = kWhite * 20.0F;
    const HdrImage before = half;
    const TakenDots taken = copyWithoutDots(half, evenImage(), input, 1);
    EXPECT_EQ(half.pixels, before.pixels);
    EXPECT_EQ(taken.pixels, 2U);
    EXPECT_NEAR(taken.light, luminance({30, 60, 15}) - 8 + 12, 1e-3);
    EXPECT_NEAR(luminance(input.at(4, 4)), 8, 1e-4) << "16 times what is around";
    EXPECT_NEAR(input.at(4, 4).g, 2 * input.at(4, 4).r, 1e-6) << "its colour stays";
    EXPECT_NEAR(luminance(input.at(0, 8)), 8, 1e-4);
    EXPECT_EQ(input.at(4, 5), half.at(4, 5));
}

TEST(BrightDots, ThatBothHalvesSawStay) {
    HdrImage half = evenImage(), other = evenImage(), input;
    half.at(4, 4) = kWhite * 60.0F;
    other.at(4, 4) = kWhite * 40.0F;
    EXPECT_EQ(copyWithoutDots(half, other, input, 1).pixels, 0U);
    EXPECT_EQ(input.pixels, half.pixels);
}

TEST(BrightDots, AreMuchBrighterThanAllAround) {
    HdrImage half = evenImage(), input;
    half.at(4, 4) = kWhite * 7.9F;
    EXPECT_EQ(copyWithoutDots(half, evenImage(), input, 1).pixels, 0U);
    half.at(4, 4) = kWhite * 8.1F;
    EXPECT_EQ(copyWithoutDots(half, evenImage(), input, 1).pixels, 1U);
}

TEST(BrightDots, AreSinglePixels) {
    HdrImage half = evenImage(), input;
    for (int x = 0; x < kDotsSide; ++x) half.at(x, 4) = kWhite * 60.0F;
    EXPECT_EQ(copyWithoutDots(half, evenImage(), input, 1).pixels, 0U) << "a line";
    EXPECT_EQ(input.pixels, half.pixels);
}

TEST(BrightDots, InTheDarkStay) {
    HdrImage half(kDotsSide, kDotsSide), input;
    half.at(4, 4) = kWhite;
    EXPECT_EQ(copyWithoutDots(half, HdrImage(kDotsSide, kDotsSide), input, 1).pixels, 0U)
        << "there is nothing by which it could be called bright";
}

TEST(BrightDots, AreTheSameForAnyThreads) {
    HdrImage half = evenImage(), one, more;
    for (int i = 0; i < 3; ++i) half.at(3 * i + 1, 3 * i + 1) = kWhite * static_cast<float>(10 + i);
    const TakenDots taken = copyWithoutDots(half, evenImage(), one, 1);
    EXPECT_EQ(taken.pixels, 3U);
    for (const int threads : {2, 3}) {
        EXPECT_EQ(copyWithoutDots(half, evenImage(), more, threads).light, taken.light);
        EXPECT_EQ(more.pixels, one.pixels);
    }
}

} // namespace
} // namespace rtcore
