#include "rtcore/scattering/lambert-inl.h"

#include "even_light.h"

#include <gtest/gtest.h>

namespace rtcore {
namespace {

namespace formulas = rtcore::HWY_NAMESPACE;

TEST(Lambert, TheDensityIsThatOfTheWholeHemisphere) {
    const auto density = [](Vec3 d) { return formulas::lambertDensity<float>(dot(d, test::kTilted)); };
    EXPECT_NEAR(test::overHemisphere(64, density), 1, 2e-4);
    EXPECT_EQ(formulas::lambertDensity<float>(-0.5F), 0);
}

TEST(Lambert, DirectionsFallByTheirDensity) {
    const auto density = [](Vec3 d) { return formulas::lambertDensity<float>(dot(d, test::kTilted)); };
    const auto sample = [](float, test::Square p) {
        return formulas::sampleLambert<float>(test::kTilted, p);
    };
    EXPECT_LT(test::excessOfSamples(sample, density), 5);
}

TEST(Lambert, DirectionsAreAboveTheSurfaceAndOfUnitLength) {
    constexpr float kAlmostOne = 0x1.fffffep-1F;
    for (const Vec3 normal : {Vec3{0, 0, 1}, Vec3{0, 0, -1}, Vec3{1, 0, 0}, test::kTilted}) {
        for (const float u : {0.0F, 0.5F, kAlmostOne}) {
            for (const float v : {0.0F, 0.5F, kAlmostOne}) {
                const Vec3 d = formulas::sampleLambert<float>(normal, {u, v});
                EXPECT_GT(dot(d, normal), 0) << u << ", " << v;
                EXPECT_NEAR(length(d), 1, 1e-6);
            }
        }
    }
}

} // namespace
} // namespace rtcore
