#include "rtcore/upsample/upsample.h"

#include "rtcore/simd/instruction_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <random>
#include <utility>

namespace rtcore {
namespace {

constexpr std::uint8_t Rgba8::*kChannels[] = {&Rgba8::r, &Rgba8::g, &Rgba8::b};

LdrImage randomImage(int width, int height) {
    LdrImage image(width, height);
    std::mt19937 random(7);
    const auto byte = [&] { return static_cast<std::uint8_t>(random() >> 24U); };
    for (Rgba8& p : image.pixels) p = {byte(), byte(), byte()};
    return image;
}

LdrImage upsampled(const LdrImage& small, int width, int height, int threads = 1) {
    LdrImage image(width, height);
    upsample(small, threads, image);
    return image;
}

/// An image of greys from 0 to 1 at points of the unit square, one in the middle of each pixel.
LdrImage sampled(int width, int height, const std::function<double(double, double)>& grey) {
    LdrImage image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto code =
                static_cast<std::uint8_t>(std::lround(255 * grey((x + 0.5) / width, (y + 0.5) / height)));
            image.at(x, y) = {code, code, code};
        }
    }
    return image;
}

/// Root mean square of the differences between an image and greys that are averaged over each of its pixels.
double errorOf(const LdrImage& image, const std::function<double(double, double)>& grey) {
    constexpr int kSide = 8, kBorder = 12;
    double sum = 0;
    int count = 0;
    for (int y = kBorder; y < image.height - kBorder; ++y) {
        for (int x = kBorder; x < image.width - kBorder; ++x) {
            double mean = 0;
            for (int i = 0; i < kSide * kSide; ++i)
                mean += grey((x + (i % kSide + 0.5) / kSide) / image.width,
                             (y + (i / kSide + 0.5) / kSide) / image.height);
            const double off = image.at(x, y).g - 255 * mean / (kSide * kSide);
            sum += off * off;
            ++count;
        }
    }
    return std::sqrt(sum / count);
}

LdrImage bilinear(const LdrImage& small, int width, int height) {
    LdrImage image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double u = (x + 0.5) * small.width / width - 0.5,
                         v = (y + 0.5) * small.height / height - 0.5;
            const auto at = [&](double i, double j) {
                return static_cast<double>(small
                                               .at(std::clamp(static_cast<int>(i), 0, small.width - 1),
                                                   std::clamp(static_cast<int>(j), 0, small.height - 1))
                                               .g);
            };
            const double i = std::floor(u), j = std::floor(v), a = u - i, b = v - j;
            const double mixed = (1 - b) * ((1 - a) * at(i, j) + a * at(i + 1, j)) +
                                 b * ((1 - a) * at(i, j + 1) + a * at(i + 1, j + 1));
            const auto code = static_cast<std::uint8_t>(std::lround(mixed));
            image.at(x, y) = {code, code, code};
        }
    }
    return image;
}

TEST(Upsample, StaysWithinThePixelsAround) {
    for (const auto& [width, height] : {std::pair{64, 48}, {61, 43}, {1, 1}, {3, 50}, {50, 3}}) {
        const LdrImage small = randomImage((width + 2) / 3, (height + 1) / 2);
        const LdrImage image = upsampled(small, width, height);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const double u = (x + 0.5) * small.width / width - 0.5,
                             v = (y + 0.5) * small.height / height - 0.5;
                const int left = static_cast<int>(std::floor(u)) - 1,
                          top = static_cast<int>(std::floor(v)) - 1;
                for (const auto channel : kChannels) {
                    int min = 255, max = 0;
                    for (int i = 0; i < 16; ++i) {
                        const int there = small.at(std::clamp(left + i % 4, 0, small.width - 1),
                                                   std::clamp(top + i / 4, 0, small.height - 1)).*
                                          channel;
                        min = std::min(min, there);
                        max = std::max(max, there);
                    }
                    ASSERT_GE(image.at(x, y).*channel, min) << x << ", " << y;
                    ASSERT_LE(image.at(x, y).*channel, max) << x << ", " << y;
                }
                ASSERT_EQ(image.at(x, y).a, 255);
            }
        }
    }
}

TEST(Upsample, KeepsEvenColours) {
    for (const Rgba8 colour : {Rgba8{255, 255, 255}, {0, 0, 0}, {3, 130, 251}}) {
        for (const int side : {18, 33, 100})
            for (const Rgba8 p : upsampled(LdrImage(17, 17, colour), side, side).pixels) EXPECT_EQ(p, colour);
    }
}

TEST(Upsample, GivesTheSameBitsForAnyThreadsAndInstructionSet) {
    const LdrImage small = randomImage(203, 101);
    const LdrImage one = upsampled(small, 611, 350);
    for (const int threads : {2, 3}) EXPECT_EQ(upsampled(small, 611, 350, threads).pixels, one.pixels);
    for (const std::string& name : instructionSets()) {
        ASSERT_TRUE(useInstructionSet(name));
        EXPECT_EQ(upsampled(small, 611, 350).pixels, one.pixels) << name;
    }
    useInstructionSet("auto");
}

// In squares all the contrast would be at their borders.
TEST(Upsample, ShowsNoSquares) {
    constexpr int kBlock = 3;
    const LdrImage small = randomImage(100, 60);
    const LdrImage image = upsampled(small, 100 * kBlock, 60 * kBlock);
    double across = 0, within = 0;
    int borders = 0, insides = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 1; x < image.width; ++x) {
            const int step = std::abs(image.at(x, y).g - image.at(x - 1, y).g);
            (x % kBlock == 0 ? across : within) += step;
            ++(x % kBlock == 0 ? borders : insides);
        }
    }
    EXPECT_LE(across / borders, 1.3 * within / insides);
    EXPECT_GT(within / insides, 10) << "something is to be seen";
}

TEST(Upsample, MakesSlantingLinesOfStaircases) {
    for (const double slope : {0.13, 0.3, 0.55, 0.9}) {
        const auto edge = [&](double x, double y) { return y > 0.2 + slope * x ? 0.8 : 0.2; };
        const LdrImage small = sampled(100, 100, edge);
        const double error = errorOf(upsampled(small, 300, 300), edge),
                     plain = errorOf(bilinear(small, 300, 300), edge);
        EXPECT_LT(error, 0.9 * plain) << slope;
    }
}

TEST(Upsample, FollowsEvenSlopes) {
    const auto ramp = [](double x, double y) { return 0.1 + 0.5 * x + 0.3 * y; };
    EXPECT_LT(errorOf(upsampled(sampled(100, 100, ramp), 270, 300), ramp), 0.5);
}

TEST(Upsample, StandsWhereTheScaleSays) {
    LdrImage small(10, 10), image(37, 37);
    small.at(4, 4) = {255, 255, 255};
    upsample(small, {4, 4}, 1, image);
    int x = 0, y = 0, max = 0;
    for (int i = 0; i < 37 * 37; ++i) {
        if (image.at(i % 37, i / 37).g > max) max = image.at(x = i % 37, y = i / 37).g;
    }
    EXPECT_TRUE(x >= 16 && x < 20 && y >= 16 && y < 20) << x << ", " << y;
}

TEST(Upsample, OfRadianceKeepsDarkAndBright) {
    HdrImage small(20, 20, {0.02F, 0.02F, 0.02F}), image(60, 60);
    small.at(10, 10) = {5000, 5000, 5000};
    upsample(small, 2, image);
    EXPECT_NEAR(image.at(3, 3).g, 0.02F, 1e-4F);
    double sum = 0;
    for (const Colour& pixel : image.pixels) {
        ASSERT_GE(pixel.g, 0.0199F);
        ASSERT_LE(pixel.g, 5001.0F);
        sum += static_cast<double>(pixel.g);
    }
    EXPECT_LT(sum / (60 * 60), 5000.0 / 400) << "a bright pixel does not spread over its neighbours";
}

TEST(Upsample, OfRadianceLetsNoPixelSpoilTheOthers) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    for (const float odd : {std::numeric_limits<float>::quiet_NaN(), kInfinity, -kInfinity, -3.0F, 1e30F}) {
        HdrImage small(20, 20, {0.5F, 0.5F, 0.5F}), image(60, 60);
        small.at(10, 10) = {odd, odd, odd};
        upsample(small, 2, image);
        for (int y = 0; y < 60; ++y) {
            for (int x = 0; x < 60; ++x) {
                ASSERT_TRUE(isFinite(image.at(x, y))) << odd;
                const bool apart = x < 20 || y < 20;
                ASSERT_NEAR(apart ? image.at(x, y).g : 0.5F, 0.5F, 1e-3F) << odd;
            }
        }
    }
}

/// Root of the mean square of the difference between neighbours.
double contrastOf(const LdrImage& image) {
    double sum = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 1; x < image.width; ++x) {
            const double step = image.at(x, y).g - image.at(x - 1, y).g;
            sum += step * step;
        }
    }
    return std::sqrt(sum / (image.height * (image.width - 1)));
}

// An image upsampled to nearly its own size keeps its detail; no pixel that becomes large is seen by itself.
TEST(Upsample, MixesLargePixelsMore) {
    const LdrImage small = randomImage(275, 275);
    const auto kept = [&](int side) {
        return contrastOf(upsampled(small, side, side)) / contrastOf(bilinear(small, side, side));
    };
    EXPECT_GT(kept(300), 1);
    EXPECT_LT(kept(825), 0.8);
}

} // namespace
} // namespace rtcore
