#include "rtcore/simd/portable_math.h"

#include "support/steps.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace rtcore {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr long double kPi = 3.14159265358979323846264338327950288L;

long double relative(float got, long double want) {
    if (want == 0) return std::fabs(got);
    return std::fabs((static_cast<long double>(got) - want) / want);
}

/// Every `step`-th float with bits in [from, to].
template <typename Check>
void forFloats(float from, float to, std::uint32_t step, Check&& check) {
    const auto last = std::bit_cast<std::uint32_t>(to);
    for (auto bits = std::bit_cast<std::uint32_t>(from); bits <= last; bits += step)
        check(std::bit_cast<float>(bits));
}

TEST(PortableLog2, ErrorBelowItsPromiseForAllPositiveFloats) {
    long double worst = 0;
    forFloats(std::numeric_limits<float>::denorm_min(), std::numeric_limits<float>::max(), 4999,
              [&](float x) {
                  worst = std::max(worst, relative(portableLog2(x), std::log2(static_cast<long double>(x))));
              });
    EXPECT_LT(worst, 2e-7L);
}

TEST(PortableLog2, KeepsItsRelativeErrorNextToOne) {
    long double worst = 0;
    const auto check = [&](float x) {
        if (x != 1)
            worst = std::max(worst, relative(portableLog2(x), std::log2(static_cast<long double>(x))));
    };
    forFloats(0.99F, 1.01F, 7, check);
    check(std::nextafter(1.0F, 0.0F));
    check(std::nextafter(1.0F, 2.0F));
    EXPECT_LT(worst, 2e-7L);
}

TEST(PortableLog2, IsExactAtPowersOfTwoAndMinusInfinityWhereThereIsNoLogarithm) {
    for (int e = -149; e <= 127; ++e) EXPECT_EQ(portableLog2(std::ldexp(1.0F, e)), static_cast<float>(e));
    for (const float x : {0.0F, -0.0F, -1.0F, -kInf, kNan}) EXPECT_EQ(portableLog2(x), -kInf) << x;
}

TEST(PortableExp2, ErrorBelowItsPromise) {
    long double worst = 0;
    for (const float x : test::steps(-126.0F, 128.0F, 1.0F / 1024)) {
        worst = std::max(worst, relative(portableExp2(x), std::exp2(static_cast<long double>(x))));
    }
    EXPECT_LT(worst, 1e-7L);
}

TEST(PortableExp2, Extremes) {
    EXPECT_EQ(portableExp2(-149), std::numeric_limits<float>::denorm_min());
    EXPECT_EQ(portableExp2(-151), 0);
    EXPECT_EQ(portableExp2(-kInf), 0);
    EXPECT_EQ(portableExp2(-std::numeric_limits<float>::max()), 0);
    EXPECT_EQ(portableExp2(128), kInf);
    EXPECT_EQ(portableExp2(kInf), kInf);
    EXPECT_EQ(portableExp2(kNan), 0);
    for (int e = -149; e <= 127; ++e) {
        EXPECT_EQ(portableExp2(static_cast<float>(e)), std::ldexp(1.0F, e)) << e;
    }
}

TEST(PortableExp, ErrorBelowItsPromise) {
    long double worst = 0;
    for (const float x : test::steps(-87.0F, 88.0F, 1.0F / 1024)) {
        worst = std::max(worst, relative(portableExp(x), std::exp(static_cast<long double>(x))));
    }
    EXPECT_LT(worst, 1e-7L);
    EXPECT_EQ(portableExp(0), 1);
    EXPECT_EQ(portableExp(-1000), 0);
    EXPECT_EQ(portableExp(1000), kInf);
    EXPECT_EQ(portableExp(kNan), 0);
}

TEST(PortablePow, ErrorBelowItsPromise) {
    long double worst = 0;
    for (const float y :
         {1e-3F, 0.1F, 1 / 2.4F, 0.5F, 1.0F, 2.4F, 10.0F, 100.0F, 1000.0F, 1e5F, -0.5F, -3.0F}) {
        forFloats(1e-30F, 1e30F, 49999, [&](float x) {
            const long double exponent = static_cast<long double>(y) * std::log2(static_cast<long double>(x));
            if (std::fabs(exponent) > 125) return;
            worst = std::max(worst, relative(portablePow(x, y), std::exp2(exponent)));
        });
    }
    EXPECT_LT(worst, 1e-6L);
}

TEST(PortablePow, ErrorBelowItsPromiseForTheSharpestHighlight) {
    long double worst = 0;
    forFloats(0.9991F, 1.0F, 3, [&](float x) {
        worst = std::max(worst, relative(portablePow(x, 1e5F), std::pow(static_cast<long double>(x),
                                                                        static_cast<long double>(1e5F))));
    });
    EXPECT_LT(worst, 1e-6L);
}

TEST(PortablePow, Extremes) {
    EXPECT_EQ(portablePow(0, 0), 1);
    EXPECT_EQ(portablePow(0, 3), 0);
    EXPECT_EQ(portablePow(-2, 2), 0);
    EXPECT_EQ(portablePow(kNan, 2), 0);
    EXPECT_EQ(portablePow(1, 1e5F), 1);
    EXPECT_EQ(portablePow(0.5F, 1e5F), 0);
    EXPECT_EQ(portablePow(2, 1e5F), kInf);
}

TEST(PortableSine, ErrorBelowItsPromise) {
    long double worst = 0;
    for (const float x : test::steps(-1000.0F, 1000.0F + 1.0F / 512 / 2, 1.0F / 512)) {
        const auto exact = static_cast<long double>(x);
        worst = std::max(worst, std::fabs(portableSin(x) - std::sin(exact)));
        worst = std::max(worst, std::fabs(portableCos(x) - std::cos(exact)));
    }
    EXPECT_LT(worst, 1e-7L);
}

TEST(PortableSine, KeepsSmallAngles) {
    for (const float x : {1e-30F, 1e-10F, 1e-4F, -1e-10F}) EXPECT_NEAR(portableSin(x) / x, 1, 1e-7);
    EXPECT_EQ(portableSin(0), 0);
    EXPECT_EQ(portableCos(0), 1);
}

TEST(PortableAtan2, ErrorBelowItsPromiseAllAroundAtAnyRadius) {
    long double worst = 0;
    for (const float radius : {1e-44F, 1e-30F, 1.0F, 1e30F}) {
        for (int i = -100000; i <= 100000; ++i) {
            const long double angle = kPi * i / 100001;
            const float y = radius * static_cast<float>(std::sin(angle));
            const float x = radius * static_cast<float>(std::cos(angle));
            const long double exact = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
            const long double error = std::fabs(portableAtan2(y, x) - exact);
            // -0 counts as 0: at the seam the result is +pi where the C library says -pi.
            worst = std::max(worst, std::min(error, std::fabs(error - 2 * kPi)));
        }
    }
    EXPECT_LT(worst, 2e-7L);
}

TEST(PortableAtan2, Extremes) {
    EXPECT_EQ(portableAtan2(0, 0), 0);
    EXPECT_EQ(portableAtan2(0, 1), 0);
    EXPECT_FLOAT_EQ(portableAtan2(0, -1), static_cast<float>(kPi));
    EXPECT_FLOAT_EQ(portableAtan2(1, 0), static_cast<float>(kPi / 2));
    EXPECT_FLOAT_EQ(portableAtan2(-1, 0), static_cast<float>(-kPi / 2));
    EXPECT_FLOAT_EQ(portableAtan2(-1, -1), static_cast<float>(-3 * kPi / 4));
    for (const float bad : {kNan, kInf, -kInf}) {
        EXPECT_EQ(portableAtan2(bad, 1), 0);
        EXPECT_EQ(portableAtan2(1, bad), 0);
        EXPECT_EQ(portableAtan2(bad, bad), 0);
    }
}

TEST(PortableAcos, ErrorBelowItsPromise) {
    long double worst = 0;
    for (int i = -200000; i <= 200000; ++i) {
        const float x = static_cast<float>(i) / 200000;
        worst = std::max(worst, std::fabs(portableAcos(x) - std::acos(static_cast<long double>(x))));
    }
    EXPECT_LT(worst, 3e-7L);
}

TEST(PortableAcos, ClampsItsArgument) {
    EXPECT_EQ(portableAcos(1), 0);
    EXPECT_EQ(portableAcos(1.5F), 0);
    EXPECT_FLOAT_EQ(portableAcos(-1.5F), static_cast<float>(kPi));
    EXPECT_EQ(portableAcos(kNan), 0);
}

} // namespace
} // namespace rtcore
