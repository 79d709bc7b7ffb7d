// Straight alpha, and what is put behind it.
#include "rtcore/math/colour.h"
#include "rtcore/post/backdrop.h"
#include "rtcore/post/straight_alpha.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rtcore {
namespace {

TEST(Backdrop, IsReadOfOneColourOrTwo) {
    for (const char* wrong : {"", "#12345", "#1234567", "123456", "#12345g", "#123456,", ",#123456",
                              "#123456,#12345", "#+12345", "#123456,#123456,#123456", "red"})
        EXPECT_FALSE(parseBackdropColours(wrong)) << wrong;
    EXPECT_TRUE(parseBackdropColours("#aBcDeF"));
    EXPECT_TRUE(parseBackdropColours("#ffffff,#000000"));
}

TEST(Backdrop, IsSeenWhereTheImageIsClearAndMixedAsLightIs) {
    LdrImage image(3, 1);
    image.pixels = {{10, 20, 30, 255}, {0, 0, 0, 0}, {255, 255, 255, 128}};
    parseBackdropColours("#ff0000")->paintBehind(image);
    EXPECT_EQ(image.pixels[0], (Rgba8{10, 20, 30}));
    EXPECT_EQ(image.pixels[1], (Rgba8{255, 0, 0}));
    const auto half = static_cast<int>(std::lround(255 * srgbEncode(128 / 255.0F)));
    EXPECT_EQ(image.pixels[2].r, 255);
    EXPECT_NEAR(image.pixels[2].g, half, 1);
    EXPECT_EQ(image.pixels[2].a, 255);
}

TEST(Backdrop, GoesFromTheTopToTheBottom) {
    LdrImage image(1, 5, {0, 0, 0, 0});
    parseBackdropColours("#000000,#c86400")->paintBehind(image);
    EXPECT_EQ(image.at(0, 0), (Rgba8{0, 0, 0}));
    EXPECT_EQ(image.at(0, 2), (Rgba8{100, 50, 0}));
    EXPECT_EQ(image.at(0, 4), (Rgba8{200, 100, 0}));
}

TEST(Backdrop, OfAnotherAspectCoversTheWholeImageAboutItsMiddle) {
    LdrImage wide(8, 2);
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 8; ++x) wide.at(x, y) = x == 3 || x == 4 ? Rgba8{0, 255, 0} : Rgba8{255, 0, 0};
    LdrImage square(4, 4, {0, 0, 0, 0});
    Backdrop(wide).paintBehind(square);
    for (const Rgba8 pixel : square.pixels) EXPECT_EQ(pixel, (Rgba8{0, 255, 0}));
}

TEST(Backdrop, IsReducedByTheMeanOfItsLight) {
    LdrImage stripes(4, 4);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x) stripes.at(x, y) = x % 2 == 0 ? Rgba8{0, 0, 0} : Rgba8{255, 255, 255};
    LdrImage image(2, 2, {0, 0, 0, 0});
    Backdrop(stripes).paintBehind(image);
    for (const Rgba8 pixel : image.pixels) EXPECT_EQ(pixel, (Rgba8{188, 188, 188}));
}

TEST(StraightAlpha, IsOneMinusTheMeanOfWhatIsSeen) {
    EXPECT_EQ(alphaOf({0, 0, 0}), 1);
    EXPECT_EQ(alphaOf({1, 1, 1}), 0);
    EXPECT_NEAR(alphaOf({0.3F, 0.6F, 0}), 0.7F, 1e-6F);
    HdrImage radiance(2, 1), transmitted(2, 1), straight;
    radiance.pixels = {{0.25F, 0.5F, 0}, {1, 1, 1}};
    transmitted.pixels = {{0.75F, 0.75F, 0.75F}, {0, 0, 0}};
    straighten(radiance, transmitted, straight);
    EXPECT_NEAR(straight.pixels[0].g, 2, 1e-5F);
    EXPECT_EQ(straight.pixels[1], (Colour{1, 1, 1}));
    LdrImage image(2, 1, {9, 9, 9});
    setAlpha(transmitted, image);
    EXPECT_EQ(image.pixels[0].a, 64);
    EXPECT_EQ(image.pixels[1].a, 255);
}

} // namespace
} // namespace rtcore
