// The curves of film and of product photographs, against their published formulas in double.
#include "rtcore/post/tone_map_block.h"

#include "rtcore/math/colour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rtcore {
namespace {

using Rgb = std::array<double, 3>;
using Matrix = std::array<Rgb, 3>;

/// "Minimal AgX Implementation" (Wrensch 2023), by columns as it is written there.
constexpr Matrix kInset{{{0.842479062253094, 0.0423282422610123, 0.0423756549057051},
                         {0.0784335999999992, 0.878468636469772, 0.0784336},
                         {0.0792237451477643, 0.0791661274605434, 0.879142973793104}}};
constexpr Matrix kOutset{{{1.19687900512017, -0.0528968517574562, -0.0529716355144438},
                          {-0.0980208811401368, 1.15190312990417, -0.0980434501171241},
                          {-0.0990297440797205, -0.0989611768448433, 1.15107367264116}}};

Rgb product(const Matrix& columns, const Rgb& x) {
    Rgb sum{};
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column) sum[row] += columns[column][row] * x[column];
    return sum;
}

Rgb agx(const Rgb& light, bool punchy) {
    Rgb code = product(kInset, light);
    for (double& c : code) {
        const double x = (std::clamp(std::log2(std::max(c, 1e-10)), -12.47393, 4.026069) + 12.47393) /
                         (4.026069 + 12.47393);
        c = 15.5 * std::pow(x, 6) - 40.14 * std::pow(x, 5) + 31.96 * std::pow(x, 4) - 6.868 * std::pow(x, 3) +
            0.4298 * x * x + 0.1191 * x - 0.00232;
    }
    if (punchy) {
        const double y = 0.2126 * code[0] + 0.7152 * code[1] + 0.0722 * code[2];
        for (double& c : code) c = y + 1.4 * (std::pow(std::max(c, 0.0), 1.35) - y);
    }
    Rgb shown = product(kOutset, code);
    for (double& c : shown) c = std::pow(std::clamp(c, 0.0, 1.0), 2.2);
    return shown;
}

/// Khronos PBR Neutral Tone Mapper (2024).
Rgb neutral(const Rgb& light) {
    constexpr double kStart = 0.8 - 0.04, kDesaturation = 0.15;
    const double x = std::min({light[0], light[1], light[2]});
    const double offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
    Rgb c = light;
    for (double& channel : c) channel -= offset;
    const double peak = std::max({c[0], c[1], c[2]});
    if (peak < kStart) return c;
    const double d = 1 - kStart, shown = 1 - d * d / (peak + d - kStart);
    const double g = 1 - 1 / (kDesaturation * (peak - shown) + 1);
    for (double& channel : c) channel = channel * shown / peak * (1 - g) + shown * g;
    return c;
}

double code(double linear) { return 255 * static_cast<double>(srgbEncode(static_cast<float>(linear))); }

Rgba8 developed(const Rgb& light, ToneMapping curve, float contrast = 0, float exposure = 1) {
    std::array<Colour, kToneBlock> block;
    block.fill({static_cast<float>(light[0]), static_cast<float>(light[1]), static_cast<float>(light[2])});
    std::array<Rgba8, kToneBlock> pixels;
    const Development how{
        .toneMapping = curve, .dithering = false, .contrast = contrast, .exposure = exposure};
    developBlock(how, block.data(), 0, 0, pixels.data());
    return pixels[5];
}

void expectCode(const Rgba8& pixel, const Rgb& shown, const Rgb& light) {
    const std::array<int, 3> channels{pixel.r, pixel.g, pixel.b};
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(channels[i], code(std::clamp(shown[i], 0.0, 1.0)), 0.52)
            << "channel " << i << " of " << light[0] << ", " << light[1] << ", " << light[2];
}

template <typename Use>
void forManyColours(Use&& use) {
    constexpr std::array<double, 7> kValues{0, 0.004, 0.05, 0.2, 0.75, 2.5, 16};
    for (const double r : kValues)
        for (const double g : kValues)
            for (const double b : kValues) use(Rgb{r, g, b});
}

TEST(ToneCurves, AgxIsThePublishedOne) {
    forManyColours(
        [](const Rgb& light) { expectCode(developed(light, ToneMapping::AgX), agx(light, false), light); });
}

TEST(ToneCurves, AgxWithFullContrastIsItsPunchyLook) {
    forManyColours(
        [](const Rgb& light) { expectCode(developed(light, ToneMapping::AgX, 1), agx(light, true), light); });
}

TEST(ToneCurves, NeutralIsThePublishedOne) {
    forManyColours(
        [](const Rgb& light) { expectCode(developed(light, ToneMapping::Neutral), neutral(light), light); });
}

TEST(ToneCurves, ExposureScalesTheLight) {
    const Rgb light{3, 1, 0.4};
    for (const ToneMapping curve : {ToneMapping::AgX, ToneMapping::Neutral})
        EXPECT_EQ(developed(light, curve, 0, 8), developed({3.0 / 8, 1.0 / 8, 0.4 / 8}, curve));
}

/// Degrees.
double hueOf(const Rgb& c) {
    const double max = std::max({c[0], c[1], c[2]}), min = std::min({c[0], c[1], c[2]});
    double turn = (c[0] - c[1]) / (max - min) + 4;
    if (c[0] == max)
        turn = (c[1] - c[2]) / (max - min);
    else if (c[1] == max)
        turn = (c[2] - c[0]) / (max - min) + 2;
    return 60 * turn;
}

TEST(ToneCurves, SaturatedColoursKeepTheirHueAtSixteenTimes) {
    for (const Rgb& colour : {Rgb{1, 0, 0}, Rgb{0, 0, 1}, Rgb{0.8, 0.1, 0.05}, Rgb{0.05, 0.1, 0.8}}) {
        const double hue = hueOf({code(colour[0]), code(colour[1]), code(colour[2])});
        for (const ToneMapping curve : {ToneMapping::AgX, ToneMapping::Neutral}) {
            const Rgba8 p = developed({16 * colour[0], 16 * colour[1], 16 * colour[2]}, curve);
            const double shown = hueOf({double(p.r), double(p.g), double(p.b)});
            EXPECT_LT(std::fabs(std::remainder(shown - hue, 360)), 10) << static_cast<int>(curve);
        }
    }
}

TEST(ToneCurves, StandAnything) {
    const double inf = std::numeric_limits<double>::infinity(),
                 nan = std::numeric_limits<double>::quiet_NaN();
    for (const ToneMapping curve : {ToneMapping::AgX, ToneMapping::Neutral}) {
        EXPECT_EQ(developed({0, 0, 0}, curve), (Rgba8{0, 0, 0, 255}));
        EXPECT_EQ(developed({nan, nan, nan}, curve), (Rgba8{0, 0, 0, 255}));
        EXPECT_EQ(developed({-5, -inf, -1}, curve), (Rgba8{0, 0, 0, 255}));
        EXPECT_GE(developed({inf, inf, inf}, curve).g, 254);
    }
}

TEST(ToneCurves, WhiteIsShownNearlyAsWhite) {
    for (const ToneMapping curve :
         {ToneMapping::Luminance, ToneMapping::Channels, ToneMapping::AgX, ToneMapping::Neutral}) {
        for (const float contrast : {0.0F, 0.5F, 1.0F, 2.0F}) {
            for (const float white : {1e-3F, 0.9F, 700.0F}) {
                const Development how{.toneMapping = curve, .dithering = false, .contrast = contrast};
                const double w = white;
                const Rgba8 p = developed({w, w, w}, curve, contrast, exposureOfWhite(how, white));
                EXPECT_EQ(p, (Rgba8{236, 236, 236, 255})) << static_cast<int>(curve) << " " << contrast;
            }
        }
    }
}

} // namespace
} // namespace rtcore
