#include "rtcore/scattering/phong-inl.h"

#include "support/steps.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace rtcore {
namespace {

namespace formulas = HWY_NAMESPACE;

float phongLobe(float cosine, float shininess) {
    return formulas::phongLobe(cosine, shininess, (shininess + 2) / (2 * kPi));
}
float roughLobe(float light, float viewer) { return formulas::roughLobe(light, viewer, 1 / (2 * kPi)); }
float terminatorFactor(Vec3 geometricNormal, Vec3 shadingNormal, Vec3 toLight) {
    return formulas::terminatorFactor<float>(geometricNormal, shadingNormal, dot(geometricNormal, toLight),
                                             dot(shadingNormal, toLight));
}

Vec3 inPlane(double degrees) {
    const double a = degrees * kPi / 180;
    return {static_cast<float>(std::sin(a)), static_cast<float>(std::cos(a)), 0};
}

/// Fraction of the light from `degrees` off the normal that the lobe gives off: its integral over the
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
            const float cosine = dot(mirrored, d);
            if (cosine > 0) sum += phongLobe(cosine, shininess) * z;
        }
    }
    return sum * 2 * kPi / kPolar / kAzimuth;
}

TEST(PhongLobe, PeakAndForm) {
    EXPECT_NEAR(phongLobe(1, 10), 1.909859, 1e-6);
    EXPECT_NEAR(phongLobe(0.5F, 10), 1.909859 / 1024, 1e-8);
}

TEST(PhongLobe, AlbedoIsOneStraightOnAndLessAside) {
    EXPECT_NEAR(lobeAlbedo(10, 0), 1, 1e-5);
    EXPECT_NEAR(lobeAlbedo(10, 60), 0.504738, 1e-4);
    EXPECT_NEAR(lobeAlbedo(10, 80), 0.228057, 1e-4);
}

TEST(PhongLobe, NeverGivesOffMoreThanItGets) {
    for (const float shininess : {1.0F, 5.0F, 200.0F}) {
        for (const int degrees : {0, 15, 50}) EXPECT_LE(lobeAlbedo(shininess, degrees), 1.0001) << shininess;
    }
}

/// GGX with alpha 1, factor by factor (Walter et al. 2007; masking of both directions by Heitz 2014).
double roughGgx(Vec3 light, Vec3 viewer) {
    const double alpha = 1, half = static_cast<double>(normalize(light + viewer).y);
    const double l = static_cast<double>(light.y), v = static_cast<double>(viewer.y);
    const double d = alpha / (kPi * std::pow(half * half * (alpha - 1) + 1, 2));
    const auto lambda = [](double cosine) { return (std::sqrt(1 + (1 / (cosine * cosine) - 1)) - 1) / 2; };
    return d / (1 + lambda(l) + lambda(v)) / (4 * l * v);
}

TEST(RoughLobe, IsGgxOfRoughnessOne) {
    for (const int light : {0, 20, 50, 85}) {
        for (const int viewer : {-80, -30, 0, 10, 60, 88}) {
            const Vec3 l = inPlane(light), v = inPlane(viewer);
            EXPECT_NEAR(roughLobe(l.y, v.y) / roughGgx(l, v), 1, 1e-5) << light << " " << viewer;
            EXPECT_EQ(roughLobe(l.y, v.y), roughLobe(v.y, l.y));
        }
    }
    EXPECT_NEAR(roughLobe(1, 1), 1 / (4 * kPi), 1e-8);
}

/// The albedo of both lobes of an exponent of at most 1.
double roughAlbedo(float shininess, double degrees) {
    const double cosine = std::cos(degrees * kPi / 180);
    constexpr int kSteps = 100000;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double z = (i + 0.5) / kSteps;
        sum +=
            2 * kPi * z * static_cast<double>(roughLobe(static_cast<float>(cosine), static_cast<float>(z)));
    }
    const auto n = static_cast<double>(shininess);
    return n * lobeAlbedo(kMinShininess, degrees) + (1 - n) * sum / kSteps;
}

/// The table of docs/shading.md.
TEST(RoughLobe, THOROUGH_HasTheAlbedoOfTheManual) {
    constexpr std::array kDegrees{0.0, 30.0, 60.0, 80.0};
    struct Row {
        float shininess;
        std::array<double, 4> albedo;
    };
    for (const Row& row : {Row{0, {0.307, 0.335, 0.451, 0.668}}, Row{0.25F, {0.480, 0.472, 0.490, 0.604}},
                           Row{0.5F, {0.653, 0.608, 0.530, 0.539}}, Row{0.75F, {0.827, 0.744, 0.569, 0.475}},
                           Row{1, {1.000, 0.881, 0.609, 0.410}}}) {
        for (std::size_t i = 0; i < kDegrees.size(); ++i) {
            EXPECT_NEAR(roughAlbedo(row.shininess, kDegrees[i]), row.albedo[i], 6e-4) << row.shininess;
        }
    }
    for (const int degrees : {0, 45, 70, 85, 89}) EXPECT_LT(roughAlbedo(0, degrees), 1) << degrees;
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

TEST(Terminator, OneWhereTheNormalsAgree) {
    for (int degrees = 0; degrees < 90; degrees += 5) {
        EXPECT_NEAR(terminatorFactor({0, 1, 0}, {0, 1, 0}, inPlane(degrees)), 1, 1e-5);
    }
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
