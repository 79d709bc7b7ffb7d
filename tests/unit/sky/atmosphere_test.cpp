#include "rtcore/sky/atmosphere.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using rtcore::ClearSky;
using rtcore::Colour;

constexpr double kDegree = std::numbers::pi / 180;

float sine(double degrees) { return static_cast<float>(std::sin(degrees * kDegree)); }

struct Chromaticity {
    double x, y;
};

Chromaticity chromaticityOf(Colour c) {
    const double r = double{c.r}, g = double{c.g}, b = double{c.b};
    const double x = 0.4124564 * r + 0.3575761 * g + 0.1804375 * b;
    const double y = 0.2126729 * r + 0.7151522 * g + 0.0721750 * b;
    const double z = 0.0193339 * r + 0.1191920 * g + 0.9503041 * b;
    return {x / (x + y + z), y / (x + y + z)};
}

Colour zenithOf(double elevation, float turbidity) {
    const ClearSky sky(sine(elevation), turbidity);
    return sky.luminance(sky.height(1), sine(elevation));
}

/// The illuminance of level ground by the sky without the sun, lux.
double illuminanceOf(double elevation, float turbidity) {
    const ClearSky sky(sine(elevation), turbidity);
    constexpr int kRows = 90, kColumns = 180;
    double sum = 0;
    for (int row = 0; row < kRows; ++row) {
        const double polar = (row + 0.5) * kDegree, c = std::cos(polar), s = std::sin(polar);
        for (int column = 0; column < kColumns; ++column) {
            const double azimuth = (column + 0.5) * 2 * kDegree;
            const double cosSun =
                c * std::sin(elevation * kDegree) + s * std::cos(azimuth) * std::cos(elevation * kDegree);
            const Colour seen = sky.luminance(sky.height(static_cast<float>(c)), static_cast<float>(cosSun));
            sum += double{rtcore::luminance(seen)} * c * s * kDegree * 2 * kDegree;
        }
    }
    return sum;
}

// By hand from appendix 2 of the paper, with turbidity 3.
TEST(Atmosphere, HasTheZenithOfThePaper) {
    const Chromaticity overhead = chromaticityOf(zenithOf(90, 3));
    EXPECT_NEAR(overhead.x, 0.25886 + 3 * 0.00394, 1e-3);
    EXPECT_NEAR(overhead.y, 0.26688 + 3 * 0.00516, 1e-3);
    // 40 degrees from the zenith, t = 0.698132: x = 9 (0.000196) + 3 (0.002792) + 0.237590, y = 9 (0.000176)
    // + 3 (0.005546) + 0.235240
    const Chromaticity lower = chromaticityOf(zenithOf(50, 3));
    EXPECT_NEAR(lower.x, 0.2477, 1e-3);
    EXPECT_NEAR(lower.y, 0.2535, 1e-3);
}

// IES Lighting Handbook (9th edition, chapter 8), clear sky: of the sky alone 0.8 + 15.5 sqrt(sin a) klx on
// level ground, of the sun 127.5 exp(-0.21 / sin a) klx on a surface that faces it.
TEST(Atmosphere, IsAsBrightAsHandbooksSay) {
    for (const double elevation : {15.0, 30.0, 45.0, 60.0}) {
        const double s = std::sin(elevation * kDegree);
        EXPECT_NEAR(illuminanceOf(elevation, 2.5F) / (800 + 15500 * std::sqrt(s)), 1, 0.35) << elevation;
        EXPECT_NEAR(double{rtcore::luminance(rtcore::sunIlluminance(sine(elevation), 2.5F))} /
                        (127500 * std::exp(-0.21 / s)),
                    1, 0.25)
            << elevation;
    }
}

TEST(Atmosphere, IsBlueAboveAndTheLowSunRed) {
    const Colour zenith = zenithOf(45, 3);
    EXPECT_GT(zenith.b, 2 * zenith.r);
    const Colour high = rtcore::sunIlluminance(sine(60), 3), low = rtcore::sunIlluminance(sine(2), 3);
    EXPECT_LT(high.r, 2 * high.b);
    EXPECT_GT(low.r, 5 * low.b);
    EXPECT_LT(rtcore::luminance(low), 0.2F * rtcore::luminance(high));
}

TEST(Atmosphere, HazeDimsTheSunAndBrightensTheSkyAroundIt) {
    const float elevation = sine(40);
    EXPECT_LT(rtcore::luminance(rtcore::sunIlluminance(elevation, 8)),
              0.6F * rtcore::luminance(rtcore::sunIlluminance(elevation, 2)));
    for (const float turbidity : {2.0F, 3.0F, 6.0F, 10.0F}) {
        const ClearSky sky(elevation, turbidity);
        const auto height = sky.height(elevation);
        EXPECT_GT(rtcore::luminance(sky.luminance(height, 1)),
                  2 * rtcore::luminance(sky.luminance(height, 0.3F)))
            << turbidity;
    }
}

TEST(Atmosphere, GrowsDarkWithoutASteep) {
    float last = rtcore::luminance(zenithOf(10, 3));
    for (double elevation = 9.9; elevation > -15; elevation -= 0.1) {
        const float now = rtcore::luminance(zenithOf(elevation, 3));
        EXPECT_LE(now, last) << elevation;
        EXPECT_GT(now, 0.8F * last) << elevation;
        last = now;
    }
    EXPECT_LT(last, 1);
    EXPECT_TRUE(rtcore::isBlack(rtcore::sunIlluminance(sine(-0.3), 3)));
    EXPECT_GT(rtcore::luminance(rtcore::sunIlluminance(sine(0), 3)), 0);
}

TEST(Atmosphere, IsFiniteAndNotNegativeEverywhere) {
    for (float turbidity = 2; turbidity <= 10; turbidity += 0.5F) {
        for (double elevation = -90; elevation <= 90; elevation += 5) {
            const ClearSky sky(sine(elevation), turbidity);
            for (const float height : {1e-6F, 0.01F, 0.3F, 1.0F}) {
                for (const float cosSun : {-1.0F, 0.0F, 0.9F, 1.0F}) {
                    const Colour c = sky.luminance(sky.height(height), cosSun);
                    EXPECT_TRUE(isFinite(c) && c.r >= 0 && c.g >= 0 && c.b >= 0)
                        << turbidity << ' ' << elevation << ' ' << height << ' ' << cosSun;
                }
            }
        }
    }
}

} // namespace
