// Functions in single precision keep the errors that they promise.
#include "rtcore/simd/functions-inl.h"

#include "support/steps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rtcore {
namespace fast_functions {
namespace {

namespace plain = HWY_NAMESPACE;

constexpr long double kExactPi = std::numbers::pi_v<long double>;

TEST(FastAtan2, KeepsItsErrorAllAroundAtAnyRadius) {
    long double worst = 0;
    for (const float radius : {1e-30F, 1.0F, 1e30F}) {
        for (int i = -50000; i <= 50000; ++i) {
            const long double angle = kExactPi * i / 50001;
            const float y = radius * static_cast<float>(std::sin(angle));
            const float x = radius * static_cast<float>(std::cos(angle));
            const long double exact = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
            worst =
                std::max(worst, std::fabs(static_cast<long double>(plain::fastAtan2<float>(y, x)) - exact));
        }
    }
    EXPECT_LT(worst, 5e-7L);
}

TEST(FastAtan2, KeepsSmallAngles) {
    for (const float y : {1e-30F, -1e-20F, 3e-10F, 1e-5F, 0.01F, 0.2F})
        EXPECT_NEAR(plain::fastAtan2<float>(y, 1) / std::atan(y), 1, 3e-7);
}

TEST(FastAtan2, OfTheAxes) {
    EXPECT_EQ(plain::fastAtan2<float>(0, 0), 0);
    EXPECT_EQ(plain::fastAtan2<float>(0, 2), 0);
    EXPECT_FLOAT_EQ(plain::fastAtan2<float>(2, 0), static_cast<float>(kExactPi / 2));
    EXPECT_FLOAT_EQ(plain::fastAtan2<float>(-2, 0), static_cast<float>(-kExactPi / 2));
    EXPECT_FLOAT_EQ(plain::fastAtan2<float>(0, -2), static_cast<float>(kExactPi));
}

TEST(FastCircle, KeepsItsErrorUpToAQuarterToEachSide) {
    long double worst = 0, worstRelative = 0;
    for (const float angle : test::steps(-1.5707F, 1.5708F, 1e-4F)) {
        const auto circle = plain::fastCircle<float>(angle);
        const auto exact = static_cast<long double>(angle);
        const long double sine = static_cast<long double>(circle.sine) - std::sin(exact);
        worst = std::max(
            {worst, std::fabs(sine), std::fabs(static_cast<long double>(circle.cosine) - std::cos(exact))});
        if (std::fabs(angle) > 1e-7F)
            worstRelative = std::max(worstRelative, std::fabs(sine / std::sin(exact)));
    }
    EXPECT_LT(worst, 3e-7L);
    EXPECT_LT(worstRelative, 3e-7L);
    EXPECT_FLOAT_EQ(plain::fastCircle<float>(1e-30F).sine, 1e-30F);
}

} // namespace
} // namespace fast_functions
} // namespace rtcore
