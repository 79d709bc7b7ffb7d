// Light found by both next event estimation and a scattered ray counts once.
#include "rtcore/pathtracing/path_weights-inl.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace rtcore {
namespace {

TEST(PathWeights, OfBothWaysSumToOne) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> exponent(-30, 30);
    for (const SamplingStrategy strategy :
         {SamplingStrategy::Both, SamplingStrategy::NextEvent, SamplingStrategy::ScatteredRays}) {
        double worst = 0;
        for (int i = 0; i < 1000000; ++i) {
            const float p = std::pow(10.0F, exponent(random)), q = std::pow(10.0F, exponent(random));
            const double sum =
                static_cast<double>(HWY_NAMESPACE::misWeightOfNextEvent<float>(strategy, p, q)) +
                HWY_NAMESPACE::misWeightOfScatteredRay<float>(strategy, q, p);
            worst = std::max(worst, std::abs(sum - 1));
        }
        EXPECT_LT(worst, 1e-6) << static_cast<int>(strategy);
    }
}

TEST(PathWeights, WhatOneWayAloneFindsIsWhole) {
    for (const SamplingStrategy strategy :
         {SamplingStrategy::Both, SamplingStrategy::NextEvent, SamplingStrategy::ScatteredRays})
        EXPECT_EQ(HWY_NAMESPACE::misWeightOfScatteredRay<float>(strategy, 0.3F, 0), 1);
}

TEST(PathWeights, TheDenserWayCountsMore) {
    EXPECT_FLOAT_EQ(HWY_NAMESPACE::misWeightOfNextEvent<float>(SamplingStrategy::Both, 3, 1), 0.9F);
    EXPECT_FLOAT_EQ(HWY_NAMESPACE::misWeightOfScatteredRay<float>(SamplingStrategy::Both, 3, 1), 0.9F);
}

} // namespace
} // namespace rtcore
