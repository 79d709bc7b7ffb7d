#include "rtcore/math/colour.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rtcore {
namespace {

double exactEncode(double x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055; }
double exactDecode(double x) { return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4); }

TEST(Srgb, FollowsTheStandardCurve) {
    for (int i = 0; i <= 100000; ++i) {
        const float x = static_cast<float>(i) / 100000;
        ASSERT_NEAR(srgbEncode(x), exactEncode(x), 3e-7) << x;
        ASSERT_NEAR(srgbDecode(x), exactDecode(x), 3e-7) << x;
    }
    EXPECT_NEAR(srgbEncode(0.18F), 0.461356, 1e-6);
    EXPECT_EQ(srgbEncode(0), 0);
    EXPECT_FLOAT_EQ(srgbEncode(1), 1);
}

TEST(Srgb, EveryCodeSurvivesTheRoundTrip) {
    for (int code = 0; code < 256; ++code) {
        const float linear = srgbDecode(static_cast<float>(code) / 255);
        EXPECT_EQ(static_cast<int>(std::floor(srgbEncode(linear) * 255 + 0.5F)), code);
    }
}

TEST(Colour, LuminanceOfWhiteIsOne) {
    EXPECT_FLOAT_EQ(luminance(kWhite), 1);
    EXPECT_GT(luminance({0, 1, 0}), luminance({1, 0, 0}));
    EXPECT_GT(luminance({1, 0, 0}), luminance({0, 0, 1}));
}

TEST(Colour, TellsFiniteAndBlack) {
    const float inf = std::numeric_limits<float>::infinity();
    EXPECT_TRUE(isFinite(Colour{1, 2, 3}));
    EXPECT_FALSE(isFinite(Colour{1, inf, 3}));
    EXPECT_FALSE(isFinite(Colour{std::nanf(""), 0, 0}));
    EXPECT_TRUE(isBlack({0, -0.0F, 0}));
    EXPECT_FALSE(isBlack({0, 0, 1e-45F}));
    EXPECT_EQ(maxComponent({1, 3, 2}), 3);
}

} // namespace
} // namespace rtcore
