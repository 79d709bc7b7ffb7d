#include "rtcore/post/tone_map-inl.h"

#include "rtcore/math/colour.h"

#include "support/srgb_code.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rtcore {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

using HWY_NAMESPACE::quantise;

float sigmoid(float y, float c) { return HWY_NAMESPACE::sigmoid(y, c); }
Colour toneMapChannels(Colour x, float c) {
    const Vec3 mapped = HWY_NAMESPACE::toneMapChannels<float>({x.r, x.g, x.b}, c);
    return {mapped.x, mapped.y, mapped.z};
}
Colour toneMapLuminance(Colour x, float c) {
    const Vec3 mapped = HWY_NAMESPACE::toneMapLuminance<float>({x.r, x.g, x.b}, c);
    return {mapped.x, mapped.y, mapped.z};
}

TEST(Sigmoid, KnownValues) {
    EXPECT_EQ(sigmoid(1, 1), 0.5F);
    EXPECT_NEAR(test::srgbCode(SrgbCurve(), 0.5F), 187.516, 2e-3);
    EXPECT_EQ(quantise(test::srgbCode(SrgbCurve(), sigmoid(1, 1)), 0.5F), 188);
    // The average at key 0.18: c = G / 0.18.
    const float average = 37;
    EXPECT_NEAR(sigmoid(average, average / 0.18F), 0.152542, 1e-6);
    EXPECT_NEAR(srgbEncode(sigmoid(average, average / 0.18F)), 0.426946, 1e-6);
}

TEST(Sigmoid, RightAtItsEnds) {
    EXPECT_EQ(sigmoid(0, 1), 0);
    EXPECT_EQ(sigmoid(kInf, 1), 1);
    EXPECT_EQ(sigmoid(std::numeric_limits<float>::max(), 1), 1);
    EXPECT_EQ(sigmoid(-1, 1), 0);
    EXPECT_EQ(sigmoid(-kInf, 1), 0);
    EXPECT_EQ(sigmoid(kNan, 1), 0);
    EXPECT_EQ(sigmoid(1, 1e-30F), 1);
    EXPECT_GE(sigmoid(1e-45F, 1e30F), 0);
}

TEST(Sigmoid, IsMonotoneAndBelowOne) {
    float before = 0;
    for (int power = -100; power < 100; ++power) {
        const float now = sigmoid(std::ldexp(1.0F, power), 1);
        EXPECT_GE(now, before);
        EXPECT_LE(now, 1);
        before = now;
    }
}

TEST(ToneMapChannels, KnownValues) {
    const Colour c = toneMapChannels({4, 1, 0.25F}, 1);
    EXPECT_FLOAT_EQ(c.r, 0.8F);
    EXPECT_FLOAT_EQ(c.g, 0.5F);
    EXPECT_FLOAT_EQ(c.b, 0.2F);
}

TEST(ToneMapLuminance, KeepsTheRatiosOfDimColours) {
    const Colour c = toneMapLuminance({0.4F, 0.1F, 0.025F}, 1);
    const float l = sigmoid(luminance({0.4F, 0.1F, 0.025F}), 1);
    EXPECT_NEAR(luminance(c), l, 1e-6);
    EXPECT_NEAR(c.r / c.g, 4, 1e-5);
    EXPECT_NEAR(c.g / c.b, 4, 1e-5);
}

TEST(ToneMapLuminance, BlendsTowardsGreyWhereAChannelExceedsOne) {
    const Colour before{1.548197F, 0.387049F, 0.096762F}; // the result of scaling alone
    const float l = sigmoid(luminance({4, 1, 0.25F}), 1);
    EXPECT_NEAR(luminance(before), l, 1e-6);
    const Colour c = toneMapLuminance({4, 1, 0.25F}, 1);
    EXPECT_NEAR(c.r, 1, 1e-6);
    EXPECT_NEAR(luminance(c), l, 1e-6);
    const float blend = (1 - l) / (before.r - l);
    EXPECT_NEAR(c.g, l + (before.g - l) * blend, 1e-5);
    EXPECT_NEAR(c.b, l + (before.b - l) * blend, 1e-5);
}

TEST(ToneMapLuminance, KeepsTheLuminanceOfAllColours) {
    for (const float size : {1e-20F, 1e-3F, 0.3F, 1.0F, 5.0F, 1e3F, 1e20F}) {
        for (const Colour tint :
             {Colour{1, 1, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0.5F, 0}, {0.1F, 0.2F, 1}}) {
            const Colour c = toneMapLuminance(tint * size, 0.7F);
            const float l = sigmoid(luminance(tint * size), 0.7F);
            EXPECT_NEAR(luminance(c), l, 2e-6F);
            EXPECT_LE(maxComponent(c), 1 + 1e-6F);
            EXPECT_GE(std::min(c.r, std::min(c.g, c.b)), -1e-6F);
        }
    }
}

TEST(ToneMapLuminance, WhatIsInfinitelyBrightIsWhite) {
    const float max = std::numeric_limits<float>::max();
    for (const Colour c : {Colour{kInf, kInf, kInf},
                           {kInf, 0, 0},
                           {1, kInf, 0},
                           {0, kInf, 0},
                           {0, 0, kInf},
                           {max, max, max}}) {
        EXPECT_EQ(toneMapLuminance(c, 1), kWhite) << c.r << ' ' << c.g << ' ' << c.b;
    }
}

TEST(ToneMapLuminance, WhatIsNoColourIsBlack) {
    for (const Colour c :
         {Colour{}, {kNan, 1, 1}, {1, kNan, 1}, {-1, -1, -1}, {-9, 1, 1}, {kInf, -kInf, 0}}) {
        EXPECT_EQ(toneMapLuminance(c, 1), Colour{});
    }
}

} // namespace
} // namespace rtcore
