#include "rtcore/render/image_sums.h"

#include "sums_support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace rtcore {
namespace {

constexpr int kSumsWidth = 13, kSumsHeight = 7;

struct PlacedSample {
    int x, y;
    Colour colour;
};

/// Samples of sizes from 1e-6 to 1e12, some negative, some not finite.
std::vector<PlacedSample> mixedSamples(int number) {
    std::mt19937 random(5);
    const auto upTo = [&](unsigned n) { return static_cast<int>(random() % n); };
    const auto channel = [&] {
        const float size = std::pow(10.0F, static_cast<float>(upTo(19) - 6));
        const float value = size * static_cast<float>(upTo(1000)) / 1000;
        if (upTo(100) == 0) return std::numeric_limits<float>::quiet_NaN();
        return upTo(8) == 0 ? -value : value;
    };
    std::vector<PlacedSample> samples;
    for (int i = 0; i < number; ++i)
        samples.push_back({upTo(kSumsWidth), upTo(kSumsHeight), {channel(), channel(), channel()}});
    return samples;
}

ImageSums emptySums(float mean = 0.7F) { return {kSumsWidth, kSumsHeight, mean}; }

ImageSums sumsOf(const std::vector<PlacedSample>& samples, std::size_t first, std::size_t step) {
    ImageSums sums = emptySums();
    for (std::size_t i = first; i < samples.size(); i += step)
        sums.add(samples[i].x, samples[i].y, samples[i].colour);
    return sums;
}

/// e of the unit 2^e, of which a channel can be 2^43 - 1.
int unitExponentOf(const ImageSums& sums) { return std::ilogb(sums.largest()) - 42; }

std::string refusalOf(ImageSums& to, const ImageSums& from) {
    try {
        to.merge(from);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "merged";
}

TEST(ImageSums, SameBitsInAnyOrderOfAddingAndMerging) {
    std::vector<PlacedSample> samples = mixedSamples(20000);
    const ImageSums all = sumsOf(samples, 0, 1);
    EXPECT_GT(all.dropped(), 0U);
    EXPECT_GT(all.clipped(), 0U);
    EXPECT_EQ(test::samplesOf(all) + all.dropped(), samples.size());

    const ImageSums a = sumsOf(samples, 0, 3), b = sumsOf(samples, 1, 3), c = sumsOf(samples, 2, 3);
    ImageSums merged = c, tree = b;
    merged.merge(a);
    merged.merge(b);
    tree.merge(c);
    ImageSums root = a;
    root.merge(tree);
    EXPECT_EQ(merged, all);
    EXPECT_EQ(root, all);

    std::shuffle(samples.begin(), samples.end(), std::mt19937(9));
    EXPECT_EQ(sumsOf(samples, 0, 1), all);
    EXPECT_EQ(test::meanOf(sumsOf(samples, 0, 1)).pixels, test::meanOf(all).pixels);
}

// Also for the thread sanitizer.
TEST(ImageSums, ThreadsAddToDifferentPixels) {
    const std::vector<PlacedSample> samples = mixedSamples(20000);
    ImageSums sums = emptySums();
    std::vector<std::thread> threads;
    for (int thread = 0; thread < 3; ++thread) {
        threads.emplace_back([&, thread] {
            for (const PlacedSample& each : samples)
                if (each.y % 3 == thread) sums.add(each.x, each.y, each.colour);
        });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(sums, sumsOf(samples, 0, 1));
}

TEST(ImageSums, ARowIsItsPixels) {
    const std::vector<Colour> row{{1, 2, 3}, {0.1F, NAN, 0}, {-4, 1e30F, 5}, {0, 0, 0}};
    ImageSums byRow = emptySums(), byPixel = emptySums();
    byRow.addRow(9, 3, row);
    for (int i = 0; i < 4; ++i) byPixel.add(9 + i, 3, row[static_cast<std::size_t>(i)]);
    EXPECT_EQ(byRow, byPixel);
    EXPECT_EQ(byRow.pixel(8, 3), ImageSums::Pixel{});
    EXPECT_EQ(byRow.pixel(9, 3).samples, 1U);
    EXPECT_EQ(byRow.pixel(10, 3), ImageSums::Pixel{});
    EXPECT_EQ(byRow.pixel(12, 3).samples, 1U);
    EXPECT_EQ(test::samplesOf(byRow), 3U);
}

TEST(ImageSums, HalvesAreOctaveByOctave) {
    std::string halves;
    for (std::uint32_t i = 0; i < 32; ++i) halves += inFirstHalf(i) ? 'A' : 'B';
    EXPECT_EQ(halves, "ABABAABBAAAABBBBAAAAAAAABBBBBBBB");
}

TEST(ImageSums, KeepTheFirstHalfBesideTheWhole) {
    ImageSums sums(2, 1, 1, true), plain(2, 1, 1);
    for (std::uint32_t i = 0; i < 6; ++i) {
        sums.add(0, 0, kWhite * static_cast<float>(i + 1), i);
        plain.add(0, 0, kWhite * static_cast<float>(i + 1), i);
    }
    sums.add(1, 0, {NAN, 0, 0}, 0);
    EXPECT_EQ(sums.pixel(0, 0), plain.pixel(0, 0));
    EXPECT_EQ(sums.firstHalf(0, 0).samples, 4U) << "0, 2, 4 and 5";
    EXPECT_EQ(sums.firstHalf(1, 0).samples, 0U);
    SampleHalves halves;
    sums.halfMeans(halves);
    EXPECT_EQ(halves.first.at(0, 0), kWhite * 3.75F);
    EXPECT_EQ(halves.second.at(0, 0), kWhite * 3.0F);
    EXPECT_EQ(halves.first.at(1, 0), Colour{});
    EXPECT_FLOAT_EQ(halves.firstFraction, 4 / 6.0F);
    EXPECT_EQ(halves.samples, 3U) << "the mean of 6 and 0";
    plain.halfMeans(halves);
    EXPECT_TRUE(halves.empty()) << "none are kept";
}

TEST(ImageSums, HalvesHaveTheSameBitsInAnyOrderOfAddingAndMerging) {
    const std::vector<PlacedSample> samples = mixedSamples(4000);
    const auto sumsFrom = [&](std::size_t first, std::size_t step) {
        ImageSums sums(kSumsWidth, kSumsHeight, 0.7F, true);
        for (std::size_t i = first; i < samples.size(); i += step)
            sums.add(samples[i].x, samples[i].y, samples[i].colour, static_cast<std::uint32_t>(i % 64));
        return sums;
    };
    const ImageSums all = sumsFrom(0, 1);
    ImageSums merged = sumsFrom(2, 3);
    merged.merge(sumsFrom(0, 3));
    EXPECT_FALSE(merged == all);
    merged.merge(sumsFrom(1, 3));
    EXPECT_TRUE(merged == all);
    const ImageSums before = merged;
    EXPECT_EQ(refusalOf(merged, sumsOf(samples, 0, 1)),
              "only some of the parts have halves of their samples");
    EXPECT_TRUE(merged == before);
}

TEST(ImageSums, TheUnitIsAPowerOfTwoOfTheMean) {
    EXPECT_EQ(unitExponentOf(emptySums(1)), -25);
    EXPECT_EQ(unitExponentOf(emptySums(0.75F)), -25);
    EXPECT_EQ(unitExponentOf(emptySums(0.5F)), -26);
    EXPECT_EQ(unitExponentOf(emptySums(std::nextafter(1.0F, 2.0F))), -24);
    EXPECT_EQ(unitExponentOf(emptySums(1e30F)), 100 - 25);
    for (const float none : {0.0F, -1.0F, NAN, INFINITY}) EXPECT_EQ(emptySums(none), emptySums(1)) << none;
}

TEST(ImageSums, MeansAreExactToAMillionth) {
    std::mt19937 random(3);
    const auto value = [&] { return 0.2F + 3 * static_cast<float>(random() >> 8U) / 16777216.0F; };
    for (const float scale : {1e-20F, 1.0F, 1e20F}) {
        ImageSums sums(1, 1, scale);
        std::array<double, 3> expected{};
        constexpr int kSamples = 10000;
        for (int i = 0; i < kSamples; ++i) {
            const Colour sample{value() * scale, -value() * scale, 1000 * value() * scale};
            sums.add(0, 0, sample);
            expected[0] += static_cast<double>(sample.r) / kSamples;
            expected[1] += static_cast<double>(sample.g) / kSamples;
            expected[2] += static_cast<double>(sample.b) / kSamples;
        }
        const Colour mean = test::meanOf(sums).at(0, 0);
        EXPECT_NEAR(mean.r / expected[0], 1, 1e-6);
        EXPECT_NEAR(mean.g / expected[1], 1, 1e-6);
        EXPECT_NEAR(mean.b / expected[2], 1, 1e-6);
    }
}

TEST(ImageSums, ConstantSamplesKeepTheirBits) {
    // 24 bits of a float of at least half the mean are whole units.
    const Colour sample{0.7F, 1 / 3.0F * 2, 123.456F};
    ImageSums sums = emptySums(1);
    for (int i = 0; i < 777; ++i) sums.add(2, 2, sample);
    EXPECT_EQ(test::meanOf(sums).at(2, 2), sample);
    EXPECT_EQ(test::meanOf(sums).at(1, 2), Colour{});
    HdrImage image(1, 1, kWhite);
    sums.mean(image);
    EXPECT_EQ(image.pixels, test::meanOf(sums).pixels);
}

TEST(ImageSums, WhatIsNotFiniteIsCountedAndNotAdded) {
    ImageSums sums = emptySums();
    sums.add(4, 4, {1, 1, 1});
    for (const float bad : {NAN, INFINITY, -INFINITY}) {
        sums.add(4, 4, {bad, 1, 1});
        sums.add(4, 4, {1, 1, bad});
    }
    EXPECT_EQ(sums.dropped(), 6U);
    EXPECT_EQ(sums.clipped(), 0U);
    EXPECT_EQ(sums.pixel(4, 4).samples, 1U);
    EXPECT_EQ(test::meanOf(sums).at(4, 4), (Colour{1, 1, 1}));
}

TEST(ImageSums, WhatIsTooLargeIsClippedAndCounted) {
    ImageSums sums = emptySums(1);
    const double largest = sums.largest();
    EXPECT_NEAR(largest, 262144, 1e-3);
    sums.add(0, 0, {262143, 0, -262143});
    EXPECT_EQ(sums.clipped(), 0U);
    sums.add(1, 0, {1e30F, 1, -1e30F});
    sums.add(2, 0, {262145, 262145, 262145});
    EXPECT_EQ(sums.clipped(), 2U);
    const std::int64_t max = (std::int64_t{1} << 43) - 1;
    EXPECT_EQ(sums.pixel(1, 0), (ImageSums::Pixel{{max, std::int64_t{1} << 25, -max}, 1}));
    EXPECT_NEAR(test::meanOf(sums).at(1, 0).r, largest, 1);
    EXPECT_EQ(test::meanOf(sums).at(1, 0).g, 1);
}

TEST(ImageSums, TheMostSamplesAtTheClampFit) {
    ImageSums sums = emptySums(1);
    sums.add(0, 0, {1e30F, -1e30F, 1e30F});
    for (int doubling = 0; doubling < 20; ++doubling) sums.merge(ImageSums(sums));
    const ImageSums::Pixel full = sums.pixel(0, 0);
    const std::int64_t max = ((std::int64_t{1} << 43) - 1) << 20;
    EXPECT_EQ(full, (ImageSums::Pixel{{max, -max, max}, ImageSums::kMaxSamples}));
    EXPECT_NEAR(test::meanOf(sums).at(0, 0).r, sums.largest(), 1);

    const ImageSums before = sums;
    ImageSums one = emptySums(1);
    one.add(0, 0, kWhite);
    EXPECT_EQ(refusalOf(sums, one), "the parts have more than 1048576 samples of a pixel");
    EXPECT_EQ(sums, before);
}

TEST(ImageSums, MergesWithItself) {
    ImageSums sums = emptySums();
    sums.add(3, 2, {1, 2, 3});
    sums.merge(sums);
    EXPECT_EQ(sums.pixel(3, 2).samples, 2U);
    EXPECT_EQ(test::meanOf(sums).at(3, 2), (Colour{1, 2, 3}));
}

TEST(ImageSums, PartsOfOtherSizesOrUnitsAreRefused) {
    ImageSums sums = emptySums(1);
    sums.add(1, 1, kWhite);
    const ImageSums before = sums;
    EXPECT_EQ(refusalOf(sums, ImageSums(kSumsWidth, kSumsHeight + 1, 1)),
              "the parts are of images of 13 x 7 and 13 x 8 pixels");
    EXPECT_EQ(refusalOf(sums, emptySums(2)),
              "the parts count in units of 2^-25 and 2^-24; they are of other scenes, views or settings");
    EXPECT_EQ(sums, before);
    EXPECT_EQ(refusalOf(sums, emptySums(0.9F)), "merged");
}

} // namespace
} // namespace rtcore
