#include "rtcore/sampling/alias-inl.h"

#include "rtcore/sampling/sample_id.h"
#include "support/random_numbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace rtcore {
namespace {

std::uint32_t sampleFrom(const AliasTable& table, std::uint32_t bits) {
    return HWY_NAMESPACE::sampleIndex<float>(table.rows(), bits);
}

/// How many of the 2^32 numbers select each index, by the rows alone.
std::vector<std::uint64_t> sampledBy(const AliasTable& table, std::size_t rows) {
    const AliasRows r = table.rows();
    std::vector<std::uint64_t> found(rows, 0);
    for (std::size_t i = 0; i < rows; ++i) {
        found[i] += r.threshold[i];
        found[r.other[i]] += (std::uint64_t{1} << static_cast<unsigned>(r.shift)) - r.threshold[i];
    }
    return found;
}

TEST(AliasTable, ProbabilitiesAreTheFractionOfAllBits) {
    test::Random random(2);
    for (const std::size_t count : {1U, 2U, 3U, 8U, 9U, 1000U, 1024U}) {
        std::vector<double> weights(count);
        for (double& w : weights) w = random.index(4) == 0 ? 0 : std::pow(10.0, random.number(-6, 6));
        weights[count / 2] = 1;
        const AliasTable table(weights);
        ASSERT_FALSE(table.empty());
        const std::size_t rows = std::size_t{1} << static_cast<unsigned>(32 - table.rows().shift);
        ASSERT_GE(rows, count);
        const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
        const std::vector<std::uint64_t> found = sampledBy(table, rows);
        for (std::size_t i = 0; i < rows; ++i) {
            const double exact = static_cast<double>(found[i]) * 0x1p-32;
            const double wanted = i < count ? weights[i] / total : 0;
            ASSERT_EQ(found[i] == 0, wanted == 0) << i;
            ASSERT_NEAR(exact, wanted, (static_cast<double>(count) * wanted + 2) * 0x1p-32) << i;
            ASSERT_EQ(table.probability(static_cast<std::uint32_t>(i)), static_cast<float>(exact));
        }
    }
}

TEST(AliasTable, SamplesByItsProbabilities) {
    const std::vector<double> weights{0, 3, 1, 0, 0.5, 5.5, 1e-9};
    const AliasTable table(weights);
    std::vector<int> found(8, 0);
    constexpr int kSamples = 100000;
    for (std::uint32_t i = 0; i < kSamples; ++i) ++found[sampleFrom(table, mixBits(i))];
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const double p = weights[i] / 10;
        EXPECT_NEAR(found[i], p * kSamples, 5 * std::sqrt(p * (1 - p) * kSamples) + 0.5) << i;
    }
    // Each index gets its part of evenly spread bits to a few.
    std::fill(found.begin(), found.end(), 0);
    for (std::uint32_t i = 0; i < 1024; ++i) ++found[sampleFrom(table, i << 22U)];
    for (std::size_t i = 0; i < weights.size(); ++i) EXPECT_NEAR(found[i], weights[i] * 102.4, 8) << i;
}

TEST(AliasTable, FarApartAndHugeWeights) {
    const AliasTable table(std::vector<double>{1e-300, 1e308, 1e308, 5e-324});
    EXPECT_EQ(table.probability(0), 0x1p-32F);
    EXPECT_EQ(table.probability(3), 0x1p-32F);
    EXPECT_NEAR(table.probability(1), 0.5, 1e-7);
    EXPECT_EQ(AliasTable(std::vector<double>{7}).probability(0), 1);
    EXPECT_EQ(sampleFrom(AliasTable(std::vector<double>{7}), 0xFFFFFFFFU), 0U);
    EXPECT_EQ(sampleFrom(AliasTable(std::vector<double>{0, 7}), 0), 1U);
}

TEST(AliasTable, EmptyWithoutProportions) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(AliasTable().empty());
    EXPECT_TRUE(AliasTable(std::vector<double>{}).empty());
    EXPECT_TRUE(AliasTable(std::vector<double>{0, 0}).empty());
    EXPECT_TRUE(AliasTable(std::vector<double>{1, kInfinity}).empty());
    EXPECT_TRUE(AliasTable(std::vector<double>{1, std::nan("")}).empty());
    EXPECT_TRUE(AliasTable(std::vector<double>{1, -1}).empty());
}

TEST(AliasTable, LargeTablesStayExact) {
    std::vector<double> weights(1U << 16U);
    for (std::uint32_t i = 0; i < weights.size(); ++i) weights[i] = i % 7 == 0 ? 0 : unitFloat(mixBits(i));
    const AliasTable table(weights);
    const std::vector<std::uint64_t> found = sampledBy(table, weights.size());
    for (std::size_t i = 0; i < weights.size(); ++i) {
        ASSERT_EQ(table.probability(static_cast<std::uint32_t>(i)), static_cast<float>(found[i]) * 0x1p-32F);
        ASSERT_EQ(found[i] == 0, weights[i] == 0);
    }
}

} // namespace
} // namespace rtcore
