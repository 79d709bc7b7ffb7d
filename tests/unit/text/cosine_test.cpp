#include "rtcore/io/text/cosine.h"

#include "unit/text/text_test_support.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using rtcore::cosineOfDegrees;
using rtcore::degreesOfCosine;

TEST(Cosine, AgreesWithTheLibraryToTheLastPlace) {
    for (int i = 0; i <= 180'000; ++i) {
        const double degrees = i / 1000.0;
        const double exact = std::cos(degrees * 3.14159265358979323846 / 180);
        ASSERT_NEAR(cosineOfDegrees(degrees), exact, 6e-8) << degrees;
    }
    EXPECT_EQ(cosineOfDegrees(0), 1.0F);
    EXPECT_EQ(cosineOfDegrees(60), 0.5F);
    EXPECT_EQ(cosineOfDegrees(90), 0.0F);
    EXPECT_EQ(cosineOfDegrees(180), -1.0F);
}

TEST(Cosine, EveryCosineComesBackBitForBit) {
    test::Random random(31);
    for (int i = 0; i < 3000; ++i) {
        const float cosine =
            (random.flag() ? 1.0F : -1.0F) * (i % 3 == 0 ? 1 - random.fraction() * 1e-5F : random.fraction());
        if (std::fabs(cosine) < 1e-7F) continue;
        EXPECT_EQ(cosineOfDegrees(degreesOfCosine(cosine)), cosine) << cosine;
    }
    for (const float cosine : {1.0F, -1.0F, 0.0F, 1e-7F, -4.37113883e-8F, 0.99999994F})
        EXPECT_EQ(cosineOfDegrees(degreesOfCosine(cosine)), cosine) << cosine;
}

TEST(Cosine, RoundAnglesStayRound) {
    for (const double degrees : {0.0, 20.0, 22.5, 30.0, 45.0, 90.0, 179.0, 180.0})
        EXPECT_EQ(degreesOfCosine(cosineOfDegrees(degrees)), degrees);
}

TEST(HalfSine, ComesBackBitForBitAndRoundAnglesStayRound) {
    test::Random random(32);
    for (int i = 0; i < 2000; ++i) {
        const float sine = std::pow(10.0F, -12 * random.fraction());
        EXPECT_EQ(rtcore::sineOfHalf(rtcore::degreesOfHalfSine(sine)), sine) << sine;
    }
    for (const double degrees : {0.0, 0.001, 0.53, 0.533, 5.0, 45.0, 90.0, 180.0})
        EXPECT_EQ(rtcore::degreesOfHalfSine(rtcore::sineOfHalf(degrees)), degrees);
    EXPECT_EQ(rtcore::sineOfHalf(180), 1.0F);
    EXPECT_EQ(rtcore::sineOfHalf(0), 0.0F);
}

TEST(Cosine, ArgumentsOutsideAreClamped) {
    EXPECT_NEAR(degreesOfCosine(2), 0, 1e-6);
    EXPECT_NEAR(degreesOfCosine(-2), 180, 1e-6);
}

} // namespace
