#include "rtcore/post/upsample.h"

#include "rtcore/post/develop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace rtcore {
namespace {

LdrImage randomImage(int width, int height) {
    LdrImage image(width, height);
    std::mt19937 random(7);
    const auto byte = [&] { return static_cast<std::uint8_t>(random() >> 24U); };
    for (Rgba8& p : image.pixels) p = {byte(), byte(), byte()};
    return image;
}

/// By the definition, in double.
double expected(const LdrImage& small, int block, int x, int y, std::uint8_t Rgba8::*channel) {
    const double u = (x + 0.5) / block - 0.5, v = (y + 0.5) / block - 0.5;
    const auto at = [&](double i, double j) {
        return static_cast<double>(small.at(std::clamp(static_cast<int>(i), 0, small.width - 1),
                                            std::clamp(static_cast<int>(j), 0, small.height - 1)).*
                                   channel);
    };
    const double i = std::floor(u), j = std::floor(v), a = u - i, b = v - j;
    return (1 - b) * ((1 - a) * at(i, j) + a * at(i + 1, j)) +
           b * ((1 - a) * at(i, j + 1) + a * at(i + 1, j + 1));
}

TEST(Upsample, InterpolatesBetweenTheMiddlesOfSquares) {
    for (const int block : {2, 4, 8}) {
        for (const auto& [width, height] : {std::pair{64, 48}, {61, 43}, {1, 1}, {3, 50}, {50, 3}}) {
            const LdrImage small = randomImage((width + block - 1) / block, (height + block - 1) / block);
            LdrImage image(width, height);
            upsample(small, block, 2, image);
            for (int y = 0; y < height; ++y) {
                for (int x = 0; x < width; ++x) {
                    for (const auto channel : {&Rgba8::r, &Rgba8::g, &Rgba8::b}) {
                        ASSERT_NEAR(image.at(x, y).*channel, expected(small, block, x, y, channel), 0.501)
                            << block << " at " << x << ", " << y;
                    }
                    ASSERT_EQ(image.at(x, y).a, 255);
                }
            }
        }
    }
}

TEST(Upsample, KeepsWhite) {
    for (const int block : {2, 4, 8}) {
        LdrImage image(33, 33);
        upsample(LdrImage(17, 17, {255, 255, 255}), block, 1, image);
        for (const Rgba8 p : image.pixels) EXPECT_EQ(p, (Rgba8{255, 255, 255}));
    }
}

TEST(DevelopPart, IsThePartOfTheWhole) {
    Frame frame;
    frame.radiance = HdrImage(203, 101);
    std::mt19937 random(5);
    for (Colour& c : frame.radiance.pixels) {
        const auto number = [&] { return static_cast<float>(random() >> 8U) / 16777216.0F * 4; };
        c = {number(), number(), number()};
    }
    const RenderSettings settings;
    const LdrImage whole = develop(frame, settings, 0.7F);
    LdrImage parts(203, 101, {1, 2, 3, 4});
    for (int y = 0; y < 101; y += 21) {
        for (int x = 0; x < 203; x += 67)
            developPart(frame.radiance, developmentOf(settings, 0.7F), {},
                        {x, y, std::min(67, 203 - x), std::min(21, 101 - y)}, parts);
    }
    EXPECT_TRUE(parts.pixels == whole.pixels);

    LdrImage one(203, 101, {1, 2, 3, 4});
    developPart(frame.radiance, developmentOf(settings, 0.7F), {}, {10, 20, 5, 6}, one);
    const auto untouched = std::count(one.pixels.begin(), one.pixels.end(), Rgba8{1, 2, 3, 4});
    EXPECT_EQ(untouched, 203 * 101 - 5 * 6);
}

} // namespace
} // namespace rtcore
