#include "rtcore/live/pixel_selector.h"

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
        samples.surface.clear(plane);
        staleness.resize(samples.surface.size());
        staleness.fill(0, 0.25F);
        for (int y = 0; y < kRows; ++y) {
            for (int x = 0; x < kColumns; ++x) {
                const float light = x < kColumns / 2 ? 0.1F : 1;
                samples.surface.set(samples.surface.index(x, y), {.light = {light, light, light}});
            }
        }
    }
    LiveLayers samples;
    PixelArray<float> staleness{0};
};

/// But for those that are chosen blindly.
std::set<std::pair<int, int>> chosen(const Image& image, double fraction, std::uint32_t number,
                                     int threads = 1) {
    PixelSelector selector;
    selector.begin(image.samples.surface.plane());
    selector.look(image.samples, 0, kRows);
    selector.choose(image.samples, image.staleness, fraction, number, threads);
    std::set<std::pair<int, int>> result;
    for (const SampleId& id : selector.chosen()) EXPECT_TRUE(result.insert({id.x, id.y}).second);
    for (const PixelSelector::Check& check : selector.checked()) {
        const SampleId pixel = selector.chosen()[check.chosen];
        if (check.blind) result.erase({pixel.x, pixel.y});
    }
    return result;
}

TEST(PixelSelector, TakesPixelsAroundWhichNothingIsKnownFirst) {
    Image image;
    for (const int x : {3, 40, 77}) {
        for (int v = 49; v <= 51; ++v) {
            for (int u = x - 1; u <= x + 1; ++u)
                image.samples.surface.forget(image.samples.surface.index(u, v));
        }
    }
    const auto found = chosen(image, 0.001, 5);
    for (const int x : {3, 40, 77}) EXPECT_TRUE(found.contains({x, 50}));
}

TEST(PixelSelector, TakesHolesBesideOtherLightBeforeStaleSamples) {
    Image image;
    const int x = kColumns / 2;
    for (const int y : {11, 33, 71}) image.samples.surface.forget(image.samples.surface.index(x, y));
    const auto found = chosen(image, 0.001, 5);
    for (const int y : {11, 33, 71}) EXPECT_TRUE(found.contains({x, y}));
}

TEST(PixelSelector, TakesMirrorsForHolesWhoseMirroredLightIsNotKnown) {
    Image image;
    image.samples.mirrors = true;
    image.samples.resizeSpecular(image.samples.surface.plane());
    const int x = kColumns / 2;
    const auto mirrorAt = [&](int y) { return image.samples.surface.index(x, y); };
    for (const int y : {11, 71})
        image.samples.surface.set(mirrorAt(y), {.light = {1, 1, 1}, .mirrors = true});
    image.samples.tints[mirrorAt(71)] = packLight(kWhite);
    image.samples.specular.set(mirrorAt(71), {.light = {0.1F, 0.1F, 0.1F}});
    const auto found = chosen(image, 1.0 / (kColumns * kRows), 5);
    EXPECT_TRUE(found.contains({x, 11}));
    EXPECT_FALSE(found.contains({x, 71}));
}

TEST(PixelSelector, TakesStaleSamplesBesideOtherLightNext) {
    const auto found = chosen(Image(), 0.02, 0);
    EXPECT_GE(found.size(), 100U);
    for (const auto& [x, y] : found) EXPECT_NEAR(x, kColumns / 2 - 0.5, 0.6) << y;
}

TEST(PixelSelector, TakesTheStalerOfSamplesThatAreOtherwiseAlike) {
    Image image;
    for (int x = 0; x < kColumns; ++x) image.staleness[image.samples.surface.index(x, 33)] = 0.9F;
    const auto found = chosen(image, 0.002, 0);
    EXPECT_FALSE(found.empty());
    for (const auto& [x, y] : found) EXPECT_TRUE(y == 33 || std::abs(x - kColumns / 2) <= 1) << x << ' ' << y;
}

TEST(PixelSelector, TakesAboutAsManyAsItMay) {
    for (const double fraction : {0.001, 0.03, 0.1, 0.5}) {
        const double count = fraction * kColumns * kRows;
        EXPECT_NEAR(static_cast<double>(chosen(Image(), fraction, 3).size()), count, 8 + 0.2 * count)
            << fraction;
    }
    EXPECT_TRUE(chosen(Image(), 0, 3).empty());
    EXPECT_EQ(chosen(Image(), 1, 3).size(), static_cast<std::size_t>(kColumns) * kRows);
}

TEST(PixelSelector, TakesFewOfManyOfTheSamePriority) {
    Image image;
    image.samples.surface.clear(image.samples.surface.plane());
    std::size_t all = 0;
    for (std::uint32_t number = 0; number < 100; ++number) all += chosen(image, 0.002, number).size();
    EXPECT_NEAR(static_cast<double>(all), 100 * 0.002 * kColumns * kRows, 0.1 * kColumns * kRows);
}

/// All have the same priority, but for two columns.
TEST(PixelSelector, ChecksAFewPixelsBlindly) {
    constexpr double kFraction = 0.05;
    std::size_t blind = 0, selected = 0, left = 0;
    for (std::uint32_t number = 0; number < 100; ++number) {
        PixelSelector selector;
        const Image image;
        selector.begin(image.samples.surface.plane());
        selector.look(image.samples, 0, kRows);
        selector.choose(image.samples, image.staleness, kFraction, number, 1 + static_cast<int>(number % 3));
        for (const PixelSelector::Check& check : selector.checked()) {
            const SampleId pixel = selector.chosen()[check.chosen];
            ++(check.blind ? blind : selected);
            left += pixel.x < kColumns / 2 ? 1U : 0U;
            EXPECT_FALSE(check.blind && std::abs(pixel.x - kColumns / 2 + 0.5) < 1);
        }
    }
    const double all = 100 * kFraction / 16 * kColumns * kRows;
    EXPECT_NEAR(static_cast<double>(blind + selected), all, 0.15 * all);
    EXPECT_NEAR(static_cast<double>(selected), kFraction * all, 0.05 * all);
    EXPECT_NEAR(static_cast<double>(left), all / 2, 0.1 * all) << "evenly spread";
}

TEST(PixelSelector, LeavesWhatWasJustTraced) {
    Image image;
    image.staleness.fill(0, 0);
    EXPECT_TRUE(chosen(image, 1, 0).empty());
}

TEST(PixelSelector, InTimeTakesEachPixel) {
    Image image;
    for (std::size_t i = 0; i < image.samples.surface.size(); ++i)
        image.samples.surface.set(i, {.light = {1, 1, 1}});
    std::set<std::pair<int, int>> all;
    for (std::uint32_t number = 0; number < 64; ++number) all.merge(chosen(image, 1.0 / 16, number));
    EXPECT_EQ(all.size(), image.samples.surface.size());
}

TEST(PixelSelector, IsTheSameForAnyNumberOfThreads) {
    const auto one = chosen(Image(), 0.13, 9);
    for (const int threads : {2, 7}) EXPECT_EQ(chosen(Image(), 0.13, 9, threads), one);
}

TEST(PixelSelector, SaysHowManyAreUnknown) {
    Image image;
    for (int x = 0; x < kColumns; ++x) {
        for (const int y : {7, 8, 9, 10}) image.samples.surface.forget(image.samples.surface.index(x, y));
    }
    PixelSelector selector;
    selector.begin(image.samples.surface.plane());
    selector.look(image.samples, 0, kRows);
    selector.choose(image.samples, image.staleness, 0.1, 0, 1);
    EXPECT_NEAR(selector.unknown(), 2.0 / kRows, 1e-9) << "the other two rows have known ones beside";
}

} // namespace
} // namespace rtcore
