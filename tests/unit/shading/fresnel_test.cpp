#include "rtcore/scattering/fresnel-inl.h"
#include "rtcore/scattering/fresnel.h"

#include "support/steps.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rtcore {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kRadians = kPi / 180;

float cosineOf(double degrees) { return static_cast<float>(std::cos(degrees * kRadians)); }
float glassAt(double degrees) { return fresnelDielectric(cosineOf(degrees), 1.5F); }
float schlickAt(double degrees) {
    return HWY_NAMESPACE::fresnelSchlick<float>({0.04F, 0.04F, 0.04F}, cosineOf(degrees)).x;
}

/// Reflectance of light that comes evenly from all directions: 2 integral F(c) c dc.
double cosineAverage(float eta) {
    double sum = 0;
    constexpr int kSteps = 200000;
    for (int i = 0; i < kSteps; ++i) {
        const double c = (i + 0.5) / kSteps;
        sum += 2 * c * fresnelDielectric(static_cast<float>(c), eta) / kSteps;
    }
    return sum;
}

TEST(FresnelDielectric, KnownValuesOfGlass) {
    EXPECT_NEAR(glassAt(0), 0.04, 1e-6);
    EXPECT_NEAR(glassAt(45), 0.050240, 1e-6);
    EXPECT_NEAR(glassAt(60), 0.089187, 1e-6);
    EXPECT_NEAR(glassAt(80), 0.387704, 4e-6);
    EXPECT_EQ(glassAt(90), 1);
}

TEST(FresnelDielectric, FromInsideGlass) {
    EXPECT_NEAR(fresnelDielectric(cosineOf(40), 1 / 1.5F), 0.245291, 5e-6);
    EXPECT_LT(fresnelDielectric(cosineOf(41.80), 1 / 1.5F), 1);
    EXPECT_EQ(fresnelDielectric(cosineOf(41.82), 1 / 1.5F), 1);
    EXPECT_EQ(fresnelDielectric(cosineOf(80), 1 / 1.5F), 1);
}

TEST(FresnelDielectric, AverageOverTheHemisphere) {
    EXPECT_NEAR(cosineAverage(1.5F), 0.091778, 2e-6);
    EXPECT_NEAR(cosineAverage(1 / 1.5F), 0.596345, 2e-6);
}

TEST(FresnelDielectric, BothSidesOfOneInterfaceAgree) {
    for (int degrees = 0; degrees < 90; degrees += 5) {
        const double inside = std::asin(std::sin(degrees * kRadians) / 1.5) / kRadians;
        EXPECT_NEAR(glassAt(degrees), fresnelDielectric(cosineOf(inside), 1 / 1.5F), 1e-5) << degrees;
    }
}

TEST(FresnelDielectric, NothingIsMirroredWhereTheIndexIsTheSame) {
    for (int degrees = 0; degrees <= 90; ++degrees) EXPECT_EQ(fresnelDielectric(cosineOf(degrees), 1), 0);
    EXPECT_EQ(fresnelDielectric(0, 1), 0);
}

TEST(FresnelDielectric, TakesCosinesThatRoundingPushedOutOfRange) {
    EXPECT_NEAR(fresnelDielectric(1.0000005F, 1.5F), 0.04, 1e-6);
    EXPECT_EQ(fresnelDielectric(-0.001F, 1.5F), 1);
}

TEST(FresnelSchlick, KnownValueAndLimits) {
    EXPECT_NEAR(schlickAt(60), 0.07, 1e-6);
    EXPECT_NEAR(schlickAt(0), 0.04, 1e-7);
    EXPECT_NEAR(schlickAt(90), 1, 1e-6);
    EXPECT_EQ(HWY_NAMESPACE::fresnelSchlick<float>({1, 0.5F, 0}, 1), (Vec3{1, 0.5F, 0}));
}

TEST(FresnelSchlick, DiffersFromTheExactCurveAsKnown) {
    double min = 0, max = 0, minAt = 0, maxAt = 0;
    for (const double degrees : test::steps(0.0, 90.0 + 0.01 / 2, 0.01)) {
        const double difference = glassAt(degrees) - schlickAt(degrees);
        if (difference < min) min = difference, minAt = degrees;
        if (difference > max) max = difference, maxAt = degrees;
    }
    EXPECT_NEAR(min, -0.035693, 2e-6);
    EXPECT_NEAR(minAt, 84.97, 0.3);
    EXPECT_NEAR(max, 0.019626, 2e-6);
    EXPECT_NEAR(maxAt, 62.33, 0.3);
}

TEST(ThinWall, SumsAllReflectionsBetweenItsTwoFaces) {
    EXPECT_NEAR(1 - thinWallReflectance(0.04F), 0.923077, 1e-6);
    EXPECT_EQ(thinWallReflectance(0), 0);
    EXPECT_EQ(thinWallReflectance(1), 1);
    // R + T R T + T R^3 T + ...
    for (const double r : {0.1, 0.5, 0.9}) {
        double sum = r;
        for (int bounce = 1; bounce < 500; ++bounce) sum += (1 - r) * (1 - r) * std::pow(r, 2 * bounce - 1);
        EXPECT_NEAR(thinWallReflectance(static_cast<float>(r)), sum, 1e-6);
    }
}

TEST(MirrorDirection, MirrorsAtTheNormal) {
    const Vec3 d = normalize({1, 2, 3});
    const Vec3 r = HWY_NAMESPACE::mirrorDirection<float>(d, {0, 1, 0}, {0, 1, 0});
    EXPECT_NEAR(length(r - Vec3{-d.x, d.y, -d.z}), 0, 1e-7);
}

TEST(MirrorDirection, IsBentBackWhereASmoothNormalLeadsIntoTheSurface) {
    const Vec3 viewer = normalize({1, 0.1F, 0}), smooth = normalize({0.5F, 1, 0});
    const Vec3 r = HWY_NAMESPACE::mirrorDirection<float>(viewer, normalize({-0.5F, 1, 0}), {0, 1, 0});
    EXPECT_NEAR(r.y, 1e-3, 1e-6);
    EXPECT_GT(HWY_NAMESPACE::mirrorDirection<float>(viewer, smooth, {0, 1, 0}).y, 1e-3);
}

TEST(Refract, FollowsSnellsLaw) {
    for (const float eta : {1.0F, 1.33F, 1.5F, 2.4F}) {
        for (int degrees = 0; degrees < 90; degrees += 5) {
            const double a = degrees * kRadians;
            const Vec3 d{static_cast<float>(std::sin(a)), static_cast<float>(-std::cos(a)), 0};
            Vec3 inside;
            ASSERT_TRUE(refract(d, {0, 1, 0}, eta, inside));
            EXPECT_NEAR(inside.x * eta, d.x, 1e-6);
            EXPECT_LT(inside.y, 0);
            EXPECT_NEAR(length(inside), 1, 1e-6);
            if (degrees > 85) continue; // near grazing the way back is as steep as rounding
            Vec3 back;
            ASSERT_TRUE(refract(inside, {0, 1, 0}, 1 / eta, back));
            EXPECT_NEAR(length(back - d), 0, 1e-5) << degrees;
        }
    }
}

TEST(Refract, LeavesGlassAtTheKnownAngle) {
    const double a = 40 * kRadians;
    Vec3 outside;
    ASSERT_TRUE(refract({static_cast<float>(std::sin(a)), static_cast<float>(-std::cos(a)), 0}, {0, 1, 0},
                        1 / 1.5F, outside));
    EXPECT_NEAR(std::atan2(outside.x, -outside.y) / kRadians, 74.618568, 1e-4);
}

TEST(Refract, FailsBeyondTheCriticalAngle) {
    const auto leaves = [](double degrees) {
        const double a = degrees * kRadians;
        Vec3 unused;
        return refract({static_cast<float>(std::sin(a)), static_cast<float>(-std::cos(a)), 0}, {0, 1, 0},
                       1 / 1.5F, unused);
    };
    EXPECT_TRUE(leaves(41.81));
    EXPECT_FALSE(leaves(41.811));
    EXPECT_FALSE(leaves(89));
}

} // namespace
} // namespace rtcore
