#include "rtcore/post/quantise.h"

#include "rtcore/math/colour.h"

#include "support/srgb_code.h"
#include "support/steps.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

namespace rtcore {
namespace {

int quantise(float code, float threshold) { return HWY_NAMESPACE::quantise(code, threshold); }
using test::srgbCode;

float ditherThreshold(int x, int y) {
    return HWY_NAMESPACE::ditherThreshold(static_cast<float>(x), static_cast<float>(y));
}

double exactCode(double x) {
    return 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055);
}

TEST(SrgbCurve, StaysWithinItsPromiseOfTheExactCurve) {
    const SrgbCurve curve;
    double worst = 0;
    const auto last = std::bit_cast<std::uint32_t>(1.0F);
    for (std::uint32_t bits = 1; bits <= last; bits += 509) {
        const auto x = std::bit_cast<float>(bits);
        worst = std::max(worst, std::fabs(srgbCode(curve, x) - exactCode(x)));
    }
    EXPECT_LT(worst, 1.0 / 500);
}

TEST(SrgbCurve, EndsAreExact) {
    const SrgbCurve curve;
    EXPECT_EQ(srgbCode(curve, 0), 0);
    EXPECT_EQ(srgbCode(curve, 1), 255);
    EXPECT_EQ(srgbCode(curve, 2), 255);
    EXPECT_EQ(srgbCode(curve, -1), 0);
    EXPECT_EQ(srgbCode(curve, std::numeric_limits<float>::infinity()), 255);
    EXPECT_EQ(srgbCode(curve, std::numeric_limits<float>::quiet_NaN()), 0);
    EXPECT_LE(srgbCode(curve, std::nextafter(1.0F, 0.0F)), 255);
}

TEST(SrgbCurve, NeverFalls) {
    const SrgbCurve curve;
    float before = 0;
    for (int i = 0; i <= 1000000; ++i) {
        const float now = srgbCode(curve, static_cast<float>(i) / 1000000);
        ASSERT_GE(now, before);
        before = now;
    }
}

TEST(Quantise, RoundsAndClamps) {
    EXPECT_EQ(quantise(187.516F, 0.5F), 188);
    EXPECT_EQ(quantise(187.4F, 0.5F), 187);
    EXPECT_EQ(quantise(0, 0.999F), 0);
    EXPECT_EQ(quantise(255, 0.999F), 255);
    EXPECT_EQ(quantise(300, 0.5F), 255);
    EXPECT_EQ(quantise(-3, 0.5F), 0);
    EXPECT_EQ(quantise(std::numeric_limits<float>::quiet_NaN(), 0.5F), 0);
}

TEST(Dither, ThresholdsAreEvenIn01) {
    double sum = 0;
    std::array<int, 8> eighths{};
    constexpr int kSide = 256;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const float t = ditherThreshold(x, y);
            ASSERT_GE(t, 0);
            ASSERT_LT(t, 1);
            sum += t;
            ++eighths[static_cast<std::size_t>(t * 8)];
        }
    }
    EXPECT_NEAR(sum / kSide / kSide, 0.5, 0.005);
    for (const int count : eighths) EXPECT_NEAR(count, kSide * kSide / 8.0, kSide * kSide / 8.0 * 0.05);
}

TEST(Dither, StaysInRangeInTheLargestPictures) {
    for (int y = 0; y < 32768; y += 117) {
        for (int x = 0; x < 32768; x += 119) {
            const float t = ditherThreshold(x, y);
            ASSERT_TRUE(t >= 0 && t < 1) << x << ' ' << y;
        }
    }
}

TEST(Dither, KeepsTheMeanOfAFlatColour) {
    for (const float code : test::steps(0.0F, 255.0F + 0.37F / 2, 0.37F)) {
        double sum = 0;
        for (int y = 100; y < 164; ++y) {
            for (int x = 200; x < 264; ++x) sum += quantise(code, ditherThreshold(x, y));
        }
        EXPECT_NEAR(sum / 64 / 64, code, 0.05);
    }
}

TEST(Dither, NeighboursDiffer) {
    for (int x = 0; x < 100; ++x) {
        EXPECT_GT(std::fabs(ditherThreshold(x, 7) - ditherThreshold(x + 1, 7)), 0.1F);
    }
}

} // namespace
} // namespace rtcore
