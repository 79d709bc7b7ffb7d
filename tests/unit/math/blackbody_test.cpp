/// The colour of black bodies against published chromaticities.
#include "rtcore/math/blackbody.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

/// Planckian locus: Planck's law (c2 = 1.4388e-2 m K) summed over the CIE 1931 2 degree observer from 380 to
/// 780 nm, each 5 nm, to the four digits.
struct OfLocus {
    double kelvin, x, y;
};
constexpr OfLocus kLocus[] = {{2000, 0.5267, 0.4133}, {2500, 0.4770, 0.4137},  {3000, 0.4369, 0.4041},
                              {4000, 0.3805, 0.3768}, {5000, 0.3451, 0.3516},  {6500, 0.3135, 0.3237},
                              {8000, 0.2952, 0.3048}, {10000, 0.2807, 0.2884}, {20000, 0.2565, 0.2577}};

/// The splines are off by 0.00054 at most, in x at 2500 K.
TEST(Blackbody, HasTheChromaticitiesOfPlancksLaw) {
    for (const OfLocus& of : kLocus) {
        const rtcore::Chromaticity is = rtcore::blackbodyChromaticity(of.kelvin);
        EXPECT_NEAR(is.x, of.x, 0.0006) << of.kelvin;
        EXPECT_NEAR(is.y, of.y, 0.0006) << of.kelvin;
    }
}

/// CIE illuminant A is a black body of 2856 K.
TEST(Blackbody, IsIlluminantA) {
    const rtcore::Chromaticity a = rtcore::blackbodyChromaticity(2856);
    EXPECT_NEAR(a.x, 0.44757, 0.0005);
    EXPECT_NEAR(a.y, 0.40745, 0.0005);
}

/// The pieces of the splines meet.
TEST(Blackbody, ChangesSteadily) {
    rtcore::Chromaticity last = rtcore::blackbodyChromaticity(rtcore::kMinTemperature);
    for (double kelvin = rtcore::kMinTemperature; kelvin <= rtcore::kMaxTemperature; kelvin += 1) {
        const rtcore::Chromaticity is = rtcore::blackbodyChromaticity(kelvin);
        EXPECT_LT(std::hypot(is.x - last.x, is.y - last.y), 0.0005) << kelvin;
        last = is;
    }
}

TEST(Blackbody, ColourHasALuminanceOfOneAndTheChromaticity) {
    for (const OfLocus& of : kLocus) {
        const rtcore::Colour c = rtcore::blackbodyColour(static_cast<float>(of.kelvin));
        EXPECT_NEAR(luminance(c), 1, 1e-6) << of.kelvin;
        // Back to XYZ (IEC 61966-2-1).
        const float x = 0.4124F * c.r + 0.3576F * c.g + 0.1805F * c.b;
        const float y = 0.2126F * c.r + 0.7152F * c.g + 0.0722F * c.b;
        const float z = 0.0193F * c.r + 0.1192F * c.g + 0.9505F * c.b;
        EXPECT_NEAR(x / (x + y + z), of.x, 0.002) << of.kelvin;
        EXPECT_NEAR(y / (x + y + z), of.y, 0.002) << of.kelvin;
    }
}

TEST(Blackbody, IsRedWhenCoolAndBlueWhenHot) {
    const rtcore::Colour candle = rtcore::blackbodyColour(1700), sky = rtcore::blackbodyColour(20000);
    EXPECT_GT(candle.r, candle.g);
    EXPECT_EQ(candle.b, 0);
    EXPECT_GT(sky.b, sky.r);
}

} // namespace
