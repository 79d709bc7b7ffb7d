#include "rtcore/lights/light_sample-inl.h"

#include "support/steps.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rtcore {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// The renderer's sample of the light, for one point.
HWY_NAMESPACE::LightSample<float> illuminate(const Light& light, Vec3 position) {
    switch (light.kind) {
    case LightKind::Directional:
        return HWY_NAMESPACE::sampleLight<LightKind::Directional, float>(light, position);
    case LightKind::Spot:
        return HWY_NAMESPACE::sampleLight<LightKind::Spot, float>(light, position);
    default:
        return HWY_NAMESPACE::sampleLight<LightKind::Point, float>(light, position);
    }
}
float spotFactor(const Light& light, float cosine) { return HWY_NAMESPACE::spotFactor(light, cosine); }

Light spot(double innerDegrees, double outerDegrees) {
    Light light;
    light.kind = LightKind::Spot;
    light.direction = {0, -1, 0};
    light.cosInner = static_cast<float>(std::cos(innerDegrees * kPi / 180));
    light.cosOuter = static_cast<float>(std::cos(outerDegrees * kPi / 180));
    return light;
}

TEST(PointLight, FallsOffWithTheSquareOfTheDistance) {
    Light light;
    light.intensity = {100, 50, 25};
    for (const float d : {1e-3F, 0.5F, 1.0F, 2.0F, 1e4F, 1e15F}) {
        const auto lit = illuminate(light, {0, -d, 0});
        EXPECT_FLOAT_EQ(lit.irradiance.x * d * d, 100);
        EXPECT_FLOAT_EQ(lit.irradiance.z * d * d, 25);
        EXPECT_EQ(lit.toLight, (Vec3{0, 1, 0}));
        EXPECT_LT(lit.free, d);
        EXPECT_NEAR(lit.free, d, d * 2e-4F);
    }
}

TEST(PointLight, GetsNoBrighterInsideItsRadius) {
    Light light;
    light.radius = 2;
    EXPECT_FLOAT_EQ(illuminate(light, {4, 0, 0}).irradiance.x, 1.0F / 16);
    EXPECT_NEAR(illuminate(light, {4, 0, 0}).free, 2, 1e-3);
    EXPECT_FLOAT_EQ(illuminate(light, {2, 0, 0}).irradiance.x, 0.25F);
    EXPECT_FLOAT_EQ(illuminate(light, {0.1F, 0, 0}).irradiance.x, 0.25F);
    EXPECT_EQ(illuminate(light, {0.1F, 0, 0}).free, 0);
}

TEST(PointLight, HasADirectionAndFiniteLightAtItsOwnPlace) {
    const auto lit = illuminate(Light{}, {0, 0, 0});
    EXPECT_FLOAT_EQ(length(lit.toLight), 1);
    EXPECT_TRUE(isFinite(lit.irradiance));
}

TEST(DirectionalLight, IsTheSameEverywhere) {
    Light light;
    light.kind = LightKind::Directional;
    light.direction = normalize({1, -1, 0});
    light.intensity = {3, 2, 1};
    for (const Vec3 p : {Vec3{}, {1e6F, 5, -3}}) {
        const auto lit = illuminate(light, p);
        EXPECT_EQ(lit.irradiance, (Vec3{3, 2, 1}));
        EXPECT_EQ(lit.toLight, -light.direction);
        EXPECT_EQ(lit.free, std::numeric_limits<float>::max());
    }
}

TEST(SpotLight, FluxOfItsCone) {
    const Light light = spot(20, 30);
    constexpr int kSteps = 200000;
    double flux = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double c = (i + 0.5) / kSteps;
        flux += 2 * kPi * spotFactor(light, static_cast<float>(c)) / kSteps;
    }
    EXPECT_NEAR(flux, 0.610355, 1e-5);
}

TEST(SpotLight, FullInsideNothingOutsideSmoothBetween) {
    const Light light = spot(20, 30);
    const auto at = [&](double degrees) {
        const double a = degrees * kPi / 180;
        const Vec3 p{static_cast<float>(2 * std::sin(a)), static_cast<float>(-2 * std::cos(a)), 0};
        return illuminate(light, p).irradiance.x * 4;
    };
    EXPECT_NEAR(at(0), 1, 1e-6);
    EXPECT_NEAR(at(19.9), 1, 1e-6);
    EXPECT_EQ(at(30.1), 0);
    EXPECT_EQ(at(180), 0);
    const double middle = std::acos((light.cosInner + light.cosOuter) / 2.0) * 180 / kPi;
    EXPECT_NEAR(at(middle), 0.5, 1e-5);
    for (const double degrees : test::steps(20.0, 30.0, 0.1))
        EXPECT_LE(at(degrees + 0.1), at(degrees) + 1e-6);
}

} // namespace
} // namespace rtcore
