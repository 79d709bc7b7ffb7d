#include "bridge/stream/histogram.h"

#include <gtest/gtest.h>

namespace {

using bridge::Histogram;

TEST(Histogram, CountsUpToTheEndOfEachBucket) {
    Histogram histogram;
    for (const double seconds : {0.0, 0.0001, 0.00011, 0.004, 2.0}) histogram.add(seconds);
    EXPECT_EQ(histogram.count(), 5U);
    EXPECT_DOUBLE_EQ(histogram.sum(), 2.00421);
    EXPECT_EQ(histogram.upTo(0), 2U) << "the end belongs to it";
    EXPECT_EQ(histogram.upTo(1), 3U);
    EXPECT_EQ(histogram.upTo(Histogram::kBounds.size() - 1), 4U);
    EXPECT_EQ(histogram.upTo(Histogram::kBounds.size()), 5U);
}

TEST(Histogram, HasGrowingBounds) {
    for (std::size_t i = 1; i < Histogram::kBounds.size(); ++i)
        EXPECT_LT(Histogram::kBounds[i - 1], Histogram::kBounds[i]);
}

TEST(Histogram, FindsQuantilesWithinABucket) {
    Histogram histogram;
    EXPECT_EQ(histogram.quantile(0.5), 0);
    for (int i = 1; i <= 1000; ++i) histogram.add(1e-5 * i); // up to 10 ms
    EXPECT_NEAR(histogram.quantile(0.5), 0.005, 0.0001);
    EXPECT_NEAR(histogram.quantile(0.95), 0.0095, 0.0001);
    EXPECT_NEAR(histogram.quantile(0.02), 0.0002, 0.00002);
    EXPECT_NEAR(histogram.quantile(1), 0.01, 1e-9);
}

TEST(Histogram, TellsTheLowerEndOfTheLastBucket) {
    Histogram histogram;
    histogram.add(50);
    EXPECT_EQ(histogram.quantile(0.5), Histogram::kBounds.back());
}

} // namespace
