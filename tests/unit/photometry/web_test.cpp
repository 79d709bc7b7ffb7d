// Distributions: their flux against closed forms, and the bounds that the tree of lights takes.
#include "rtcore/lights/photometry-inl.h"
#include "rtcore/scene/light_power.h"
#include "rtcore/scene/photometry.h"
#include "support/random_numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace rtcore {
namespace {

constexpr double kExactPi = std::numbers::pi;

PhotometricWeb webOf(double step, double last, double (*candela)(double gamma)) {
    PhotometricWeb web{{}, {0, 360}, {}};
    for (double gamma = 0; gamma <= last; gamma += step) web.gammas.push_back(gamma);
    for (int plane = 0; plane < 2; ++plane)
        for (const double gamma : web.gammas) web.candela.push_back(candela(gamma * kExactPi / 180));
    return web;
}
double cosineOf(double gamma) { return std::max(1000 * std::cos(gamma), 0.0); }

TEST(PhotometricWeb, HasTheFluxOfClosedForms) {
    EXPECT_NEAR(lumensOf(webOf(180, 180, [](double) { return 10.0; })), 40 * kExactPi, 1e-9);
    EXPECT_NEAR(lumensOf(webOf(30, 90, [](double) { return 10.0; })), 20 * kExactPi, 1e-9);
    // Linear in the angle: 2 pi int (pi - x) sin x = 2 pi^2.
    EXPECT_NEAR(lumensOf(webOf(180, 180, [](double x) { return kExactPi - x; })), 2 * kExactPi * kExactPi,
                1e-9);
    EXPECT_NEAR(lumensOf(webOf(1, 90, cosineOf)), 1000 * kExactPi, 0.1);
}

TEST(PhotometricWeb, IsKeptOnce) {
    const std::uint32_t first = keepPhotometry(webOf(1, 90, cosineOf));
    EXPECT_GT(first, 0U);
    EXPECT_EQ(keepPhotometry(webOf(1, 90, cosineOf)), first);
    EXPECT_NE(keepPhotometry(webOf(5, 90, cosineOf)), first);
    EXPECT_EQ(photometry(0).mean, 1);
    EXPECT_EQ(photometry(kMaxPhotometries + 7).mean, 1);
    EXPECT_NEAR(photometry(first).mean, 0.25F, 1e-4F);
}

/// intensity <= cos(angle - spread), and 0 beyond spread + edge.
TEST(PhotometricWeb, IsBoundedByItsCone) {
    const std::array<double (*)(double), 4> shapes{cosineOf, [](double x) { return std::exp(-x * x * 30); },
                                                   [](double x) { return 0.01 + std::pow(std::sin(x), 4.0); },
                                                   [](double) { return 1.0; }};
    test::Random random(3);
    for (const auto& shape : shapes) {
        for (const double last : {30.0, 90.0, 180.0}) {
            const Photometry& web = photometry(keepPhotometry(webOf(5, last, shape)));
            const float spread = std::acos(web.cosSpread), edge = std::acos(web.cosEdge);
            for (int i = 0; i < 2000; ++i) {
                const float gamma = random.number(0, static_cast<float>(kExactPi));
                const float factor =
                    HWY_NAMESPACE::measuredFactor<float>(web, std::cos(gamma), std::sin(gamma), 0.0F);
                ASSERT_TRUE(factor >= 0 && factor <= 1 + 1e-6F);
                if (gamma > spread + edge)
                    ASSERT_LE(factor, 2e-3F) << gamma;
                else
                    ASSERT_LE(factor, std::cos(std::max(gamma - spread, 0.0F)) + 1e-3F) << gamma;
                if (std::cos(gamma) < web.cosReach - 1e-5F) {
                    ASSERT_EQ(factor, 0);
                }
            }
        }
    }
}

} // namespace
} // namespace rtcore
