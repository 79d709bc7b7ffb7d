#include "rtcore/live/pixel_choice.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

namespace rtcore {
namespace {

constexpr int kColumns = 96, kRows = 80;

/// A lit surface, dark on the left and bright on the right, whose samples are all as stale.
struct Image {
    Image() {
        ImagePlane plane;
        plane.width = kColumns;
        plane.height = kRows;
        samples.clear(plane);
        staleness.resize(samples.size());
        staleness.fill(0, 0.25F);
        for (int y = 0; y < kRows; ++y) {
            for (int x = 0; x < kColumns; ++x) {
                const float light = x < kColumns / 2 ? 0.1F : 1;
                samples.set(samples.index(x, y), {.light = {light, light, light}});
            }
        }
    }
    LiveSamples samples;
    PixelArray<float> staleness{0};
};

std::set<std::pair<int, int>> chosen(const Image& image, double share, std::uint32_t number,
                                     int threads = 1) {
    PixelChoice choice;
    choice.choose(image.samples, image.staleness, share, number, threads);
    std::set<std::pair<int, int>> result;
    for (const SampleId& id : choice.chosen()) EXPECT_TRUE(result.insert({id.x, id.y}).second);
    return result;
}

TEST(PixelChoice, TakesPixelsWithoutASampleFirst) {
    Image image;
    for (const int x : {3, 40, 77}) image.samples.states[image.samples.index(x, 50)] = 0;
    const auto found = chosen(image, 0.01, 5);
    for (const int x : {3, 40, 77}) EXPECT_TRUE(found.contains({x, 50}));
}

TEST(PixelChoice, TakesStaleSamplesBesideOtherLightNext) {
    const auto found = chosen(Image(), 0.02, 0);
    EXPECT_GE(found.size(), 100U);
    for (const auto& [x, y] : found) EXPECT_NEAR(x, kColumns / 2 - 0.5, 0.6) << y;
}

TEST(PixelChoice, TakesTheStalerOfSamplesThatAreOtherwiseAlike) {
    Image image;
    for (int x = 0; x < kColumns; ++x) image.staleness[image.samples.index(x, 33)] = 0.9F;
    const auto found = chosen(image, 0.002, 0);
    EXPECT_FALSE(found.empty());
    for (const auto& [x, y] : found) EXPECT_TRUE(y == 33 || std::abs(x - kColumns / 2) <= 1) << x << ' ' << y;
}

TEST(PixelChoice, TakesAboutAsManyAsItMay) {
    for (const double share : {0.001, 0.03, 0.1, 0.5}) {
        const double count = share * kColumns * kRows;
        EXPECT_NEAR(static_cast<double>(chosen(Image(), share, 3).size()), count, 8 + 0.2 * count) << share;
    }
    EXPECT_TRUE(chosen(Image(), 0, 3).empty());
    EXPECT_EQ(chosen(Image(), 1, 3).size(), static_cast<std::size_t>(kColumns) * kRows);
}

TEST(PixelChoice, LeavesWhatWasJustTraced) {
    Image image;
    image.staleness.fill(0, 0);
    EXPECT_TRUE(chosen(image, 1, 0).empty());
}

TEST(PixelChoice, InTimeTakesEachPixel) {
    Image image;
    for (std::size_t i = 0; i < image.samples.size(); ++i) image.samples.set(i, {.light = {1, 1, 1}});
    std::set<std::pair<int, int>> all;
    for (std::uint32_t number = 0; number < kTurns; ++number) all.merge(chosen(image, 1.0 / 16, number));
    EXPECT_EQ(all.size(), image.samples.size());
}

TEST(PixelChoice, IsTheSameForAnyNumberOfThreads) {
    const auto one = chosen(Image(), 0.13, 9);
    for (const int threads : {2, 7}) EXPECT_EQ(chosen(Image(), 0.13, 9, threads), one);
}

TEST(PixelChoice, SaysHowManyAreUnknown) {
    Image image;
    for (int x = 0; x < kColumns; ++x) image.samples.states[image.samples.index(x, 7)] = 0;
    PixelChoice choice;
    choice.choose(image.samples, image.staleness, 0.1, 0, 1);
    EXPECT_NEAR(choice.unknown(), 1.0 / kRows, 1e-9);
}

} // namespace
} // namespace rtcore
