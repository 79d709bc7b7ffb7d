#include "rtcore/shading/phong.h"

#include "support/steps.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rtcore {
namespace {

Vec3 inPlane(double degrees) {
    const double a = degrees * kPi / 180;
    return {static_cast<float>(std::sin(a)), static_cast<float>(std::cos(a)), 0};
}

/// Share of the light from `degrees` off the normal that the lobe gives off: its integral over the
/// hemisphere.
double lobeAlbedo(float shininess, double degrees) {
    const Vec3 mirrored = inPlane(degrees);
    constexpr int kPolar = 1000, kAzimuth = 1000;
    double sum = 0;
    for (int i = 0; i < kPolar; ++i) {
        const double z = (i + 0.5) / kPolar; // cosine of the polar angle: even in solid angle
        const double r = std::sqrt(1 - z * z);
        for (int j = 0; j < kAzimuth; ++j) {
            const double azimuth = 2 * kPi * (j + 0.5) / kAzimuth;
            const Vec3 d{static_cast<float>(r * std::cos(azimuth)), static_cast<float>(z),
                         static_cast<float>(r * std::sin(azimuth))};
            sum += phongLobe(dot(mirrored, d), shininess) * z;
        }
    }
    return sum * 2 * kPi / kPolar / kAzimuth;
}

TEST(PhongLobe, PeakAndForm) {
    EXPECT_NEAR(phongLobe(1, 10), 1.909859, 1e-6);
    EXPECT_NEAR(phongLobe(0.5F, 10), 1.909859 / 1024, 1e-8);
    EXPECT_NEAR(phongLobe(0.7F, 0), 1 / kPi, 1e-6);
    EXPECT_EQ(phongLobe(0, 10), 0);
    EXPECT_EQ(phongLobe(-0.5F, 2), 0);
    EXPECT_EQ(phongLobe(-0.5F, 0), 0);
}

TEST(PhongLobe, AlbedoIsOneStraightOnAndLessAside) {
    EXPECT_NEAR(lobeAlbedo(10, 0), 1, 1e-5);
    EXPECT_NEAR(lobeAlbedo(10, 60), 0.504738, 1e-4);
    EXPECT_NEAR(lobeAlbedo(10, 80), 0.228057, 1e-4);
}

TEST(PhongLobe, NeverGivesOffMoreThanItGets) {
    for (const float shininess : {0.0F, 1.0F, 5.0F, 200.0F}) {
        for (const int degrees : {0, 15, 50}) EXPECT_LE(lobeAlbedo(shininess, degrees), 1.0001) << shininess;
    }
}

TEST(PhongLobe, StaysFiniteForTheSharpestHighlight) {
    EXPECT_NEAR(phongLobe(1, 100000), 100002 / (2 * kPi), 0.01);
    EXPECT_TRUE(std::isfinite(phongLobe(1.000001F, 100000)));
}

TEST(Terminator, FollowsItsPolynomial) {
    const Vec3 light = inPlane(80);
    for (const double degrees : test::steps(0.0, 80.0 + 1.0 / 2, 1.0)) {
        const Vec3 ns = inPlane(degrees);
        const double g = std::min(1.0, std::cos(80 * kPi / 180) / (std::cos((80 - degrees) * kPi / 180) *
                                                                   std::cos(degrees * kPi / 180)));
        EXPECT_NEAR(terminatorFactor({0, 1, 0}, ns, light), -g * g * g + g * g + g, 1e-5);
    }
}

TEST(Terminator, HalfGivesFiveEighths) {
    // Angles a from Ng to Ns and b from there to the light: G = cos(a+b) / (cos a cos b) = 1 - tan a tan b.
    const double a = std::atan(std::sqrt(0.5));
    const double degrees = a * 180 / kPi;
    EXPECT_NEAR(terminatorFactor({0, 1, 0}, inPlane(degrees), inPlane(2 * degrees)), 0.625, 1e-6);
}

TEST(Terminator, OneWhereTheNormalsAgreeAndZeroBehind) {
    for (int degrees = 0; degrees < 90; degrees += 5) {
        EXPECT_NEAR(terminatorFactor({0, 1, 0}, {0, 1, 0}, inPlane(degrees)), 1, 1e-5);
    }
    EXPECT_EQ(terminatorFactor({0, 1, 0}, inPlane(20), inPlane(91)), 0);
    EXPECT_EQ(terminatorFactor({0, 1, 0}, inPlane(-20), inPlane(75)), 0);
}

TEST(Terminator, FadesToZeroWithoutAStep) {
    float before = terminatorFactor({0, 1, 0}, inPlane(30), inPlane(90));
    EXPECT_NEAR(before, 0, 1e-6);
    for (const double steeper : test::steps(0.1, 30.0, 0.1)) {
        const float now = terminatorFactor({0, 1, 0}, inPlane(30), inPlane(90 - steeper));
        EXPECT_GE(now, before - 1e-6F);
        EXPECT_LT(now - before, 0.01F);
        before = now;
    }
    EXPECT_LE(before, 1);
}

} // namespace
} // namespace rtcore
