#include "rtcore/post/develop.h"

#include "rtcore/post/quantise.h"
#include "support/one_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace rtcore {
namespace {

Frame randomFrame(int width, int height) {
    Frame frame;
    frame.radiance = HdrImage(width, height);
    frame.covered.assign(frame.radiance.pixels.size(), 255);
    std::mt19937 random(5);
    for (Colour& c : frame.radiance.pixels) {
        const auto number = [&] { return static_cast<float>(random() >> 8U) / 16777216.0F * 4; };
        c = {number(), number(), number()};
    }
    return frame;
}

Frame flatFrame(Colour c, int width = 64, int height = 64) {
    Frame frame;
    frame.radiance = HdrImage(width, height, c);
    frame.covered.assign(frame.radiance.pixels.size(), 255);
    return frame;
}

TEST(Develop, KnownValueWithoutDithering) {
    RenderSettings settings;
    settings.dithering = false;
    for (const Rgba8 p : test::develop(flatFrame({1, 1, 1}), settings, 1).pixels)
        EXPECT_EQ(p, (Rgba8{188, 188, 188, 255}));
    settings.toneMapping = ToneMapping::Channels;
    const LdrImage image = test::develop(flatFrame({4, 1, 0.25F}), settings, 1);
    EXPECT_EQ(image.at(3, 3), (Rgba8{231, 188, 124, 255}));
}

TEST(Develop, DitheringKeepsTheMean) {
    RenderSettings settings;
    const LdrImage image = test::develop(flatFrame({1, 1, 1}), settings, 1);
    double sum = 0;
    for (const Rgba8 p : image.pixels) sum += p.g;
    EXPECT_NEAR(sum / static_cast<double>(image.pixels.size()), 187.516, 0.05);
    EXPECT_EQ(image.pixels, test::develop(flatFrame({1, 1, 1}), settings, 1).pixels);
}

TEST(Develop, BlackStaysBlackAndTheBrightestWhite) {
    const RenderSettings settings;
    for (const Rgba8 p : test::develop(flatFrame({}), settings, 1).pixels)
        ASSERT_EQ(p, (Rgba8{0, 0, 0, 255}));
    const float inf = std::numeric_limits<float>::infinity();
    for (const Rgba8 p : test::develop(flatFrame({1, inf, 0}), settings, 1).pixels)
        ASSERT_EQ(p, (Rgba8{255, 255, 255, 255}));
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const Rgba8 p : test::develop(flatFrame({1, nan, 0}), settings, 1).pixels)
        ASSERT_EQ(p, (Rgba8{0, 0, 0, 255}));
}

TEST(Develop, OddAndEmptySizes) {
    for (const auto& [w, h] : {std::pair{1, 1}, {33, 7}, {1, 100}, {0, 0}}) {
        const LdrImage image = test::develop(flatFrame({1, 2, 3}, w, h), RenderSettings{}, 1);
        EXPECT_EQ(image.width, w);
        EXPECT_EQ(image.pixels.size(), static_cast<std::size_t>(w * h));
    }
}

TEST(Develop, TheSameBitsForAnyNumberOfThreads) {
    const Frame frame = randomFrame(123, 77);
    const RenderSettings settings;
#ifdef _OPENMP
    const int before = omp_get_max_threads();
    omp_set_num_threads(1);
#endif
    const LdrImage one = test::develop(frame, settings, 0.5F);
    const float exposure = test::exposureFor(frame, settings.exposure);
#ifdef _OPENMP
    omp_set_num_threads(7);
#endif
    const LdrImage many = test::develop(frame, settings, 0.5F);
    EXPECT_EQ(one.pixels, many.pixels);
    EXPECT_EQ(test::exposureFor(frame, settings.exposure), exposure);
#ifdef _OPENMP
    omp_set_num_threads(before);
#endif
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
    const LdrImage whole = test::develop(frame, settings, 0.7F);
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
