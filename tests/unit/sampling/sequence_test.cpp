// Random numbers by name: pointInSequence() and what it is made of.
#include "rtcore/sampling/sample_id.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace rtcore {
namespace {

SquarePoint pathPoint(std::uint32_t x, std::uint32_t sub, SampleDimension dimension, std::uint32_t bounce) {
    return pointInSequence({static_cast<std::uint16_t>(x), 7, sub}, 0, dimension, bounce);
}

/// Sobol's second dimension by its direction numbers.
std::uint32_t sobolByColumns(std::uint32_t i) {
    std::uint32_t sum = 0;
    for (std::uint32_t v = 1U << 31U; i != 0; i >>= 1U, v ^= v >> 1U) sum ^= (i & 1U) != 0 ? v : 0;
    return sum;
}

TEST(RandomBits, TheFormulasOfThePapers) {
    EXPECT_EQ(reversedBits(1), 0x80000000U);
    EXPECT_EQ(reversedBits(0x12345678U), 0x1E6A2C48U);
    for (std::uint32_t i = 0; i < 3000; ++i) {
        const std::uint32_t wide = i < 1500 ? i : mixBits(i);
        ASSERT_EQ(reversedBits(reversedSobol(wide)), sobolByColumns(wide));
        ASSERT_EQ(reversedBits(reversedBits(wide)), wide);
    }
}

TEST(RandomBits, OwenScramblingFlipsABitByThoseAboveIt) {
    for (std::uint32_t trial = 0; trial < 2000; ++trial) {
        const std::uint32_t seed = mixBits(trial), x = mixBits(seed ^ 1U), bit = trial % 32;
        const std::uint32_t change = owenScrambled(x, seed) ^ owenScrambled(x ^ 1U << bit, seed);
        ASSERT_EQ(change >> bit, 1U) << trial;
    }
}

TEST(Sequence, AnyPowerOfTwoOfPointsHasOneInEachElementaryInterval) {
    for (std::uint32_t pixel = 0; pixel < 8; ++pixel) {
        for (std::uint32_t k = 0; k <= 10; ++k) {
            for (std::uint32_t wide = 0; wide <= k; ++wide) {
                std::vector<int> found(1U << k, 0);
                const auto columns = static_cast<float>(1U << wide);
                const auto rows = static_cast<float>(1U << (k - wide));
                for (std::uint32_t i = 0; i < 1U << k; ++i) {
                    const SquarePoint p = pathPoint(pixel, i, SampleDimension::Direction, pixel % 3);
                    ++found[static_cast<std::size_t>(p.u * columns) * static_cast<std::size_t>(rows) +
                            static_cast<std::size_t>(p.v * rows)];
                }
                ASSERT_EQ(std::count(found.begin(), found.end(), 1), 1 << k)
                    << pixel << ": 2^" << k << " points, 2^" << wide << " columns";
            }
        }
    }
}

/// Root mean square of the relative error of an integral over two pairs of one path, each of them with a
/// jump.
double errorOfTwoPairs(std::uint32_t samples, std::uint32_t images) {
    const double truth = 0.25 * 3.14159265358979 * 0.5;
    double squares = 0;
    for (std::uint32_t image = 0; image < images; ++image) {
        double sum = 0;
        for (std::uint32_t i = 0; i < samples; ++i) {
            const SquarePoint a = pathPoint(image, i, SampleDimension::Direction, 1);
            const SquarePoint b = pathPoint(image, i, SampleDimension::AreaLight, 2);
            sum += a.u * a.u + a.v * a.v < 1 && b.u + b.v < 1 ? 1 : 0;
        }
        const double error = sum / samples / truth - 1;
        squares += error * error;
    }
    return std::sqrt(squares / images);
}

TEST(Sequence, TwoPairsOfOnePathConverge) {
    // Independent samples: sqrt((1 / p - 1) / n), p = pi / 8. The interaction of the pairs is left, with the
    // variance (pi / 4 - pi^2 / 16) / 4: .42 of the independent deviation. 1000 images tell it to
    // 1 / sqrt(2000), 5 sigma are 11 %; errors of the pairs by themselves add 12 % at most from 256 points
    // on.
    for (const std::uint32_t samples : {256U, 1024U}) {
        const double independent = std::sqrt((2.546479089 - 1) / samples);
        const double found = errorOfTwoPairs(samples, 1000);
        EXPECT_LT(found, 0.53 * independent) << samples;
        EXPECT_GT(found, 0.3 * independent) << samples;
    }
}

/// The correlation of u or v of one sequence with u or v of another, over all points of many pixels.
template <typename A, typename B>
double greatestCorrelation(std::uint32_t count, A first, B second) {
    double uu = 0, uv = 0, vu = 0, vv = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const SquarePoint a = first(i), b = second(i);
        uu += (a.u - 0.5) * (b.u - 0.5);
        uv += (a.u - 0.5) * (b.v - 0.5);
        vu += (a.v - 0.5) * (b.u - 0.5);
        vv += (a.v - 0.5) * (b.v - 0.5);
    }
    const double max = std::max({std::abs(uu), std::abs(uv), std::abs(vu), std::abs(vv)});
    return max * 12 / count;
}

TEST(Sequence, UsesBouncesPixelsAndSeedsAreIndependent) {
    constexpr std::uint32_t kCount = 16384;
    constexpr double kBound = 5 / 128.0; // 5 sigma of as many independent pairs
    using enum SampleDimension;
    const auto of = [](SampleDimension dimension, std::uint32_t bounce, std::uint32_t x, std::uint32_t seed) {
        return [=](std::uint32_t i) {
            // 16 pixels: their sequences whole; and many pixels: their first points.
            const std::uint32_t pixel = i / 1024;
            return pointInSequence({static_cast<std::uint16_t>(x + 3 * pixel), 0, i % 1024}, seed, dimension,
                                   bounce);
        };
    };
    const auto first = of(Direction, 1, 0, 0);
    for (const SampleDimension other : {Position, Lens, AreaLight, Hole, Glass, Lobe, Light}) {
        EXPECT_LT(greatestCorrelation(kCount, first, of(other, 1, 0, 0)), kBound);
    }
    for (const std::uint32_t bounce : {0U, 2U, 3U, 16U}) {
        EXPECT_LT(greatestCorrelation(kCount, first, of(Direction, bounce, 0, 0)), kBound) << bounce;
    }
    EXPECT_LT(greatestCorrelation(kCount, first, of(Direction, 1, 1, 0)), kBound);
    EXPECT_LT(greatestCorrelation(kCount, first, of(Direction, 1, 0, 1)), kBound);
}

TEST(Sequence, FirstPointsOfPixelsAreIndependentToo) {
    constexpr std::uint32_t kCount = 40000;
    constexpr double kBound = 5 / 200.0;
    const auto at = [](std::uint32_t dx, std::uint32_t sub) {
        return [=](std::uint32_t i) {
            const SampleId id{static_cast<std::uint16_t>(i % 200 + dx), static_cast<std::uint16_t>(i / 200),
                              sub};
            return pointInSequence(id, 3, SampleDimension::Position, 0);
        };
    };
    EXPECT_LT(greatestCorrelation(kCount, at(0, 0), at(1, 0)), kBound);
    EXPECT_LT(greatestCorrelation(kCount, at(0, 1), at(1, 1)), kBound);
    EXPECT_LT(greatestCorrelation(kCount, at(0, 0), at(2, 5)), kBound);
    // 64 squares; chi-square of 63 degrees, mean 63, sigma 11.2.
    std::vector<double> found(64, 0);
    for (std::uint32_t i = 0; i < kCount; ++i) {
        const SquarePoint p = at(0, 0)(i);
        found[static_cast<std::size_t>(p.u * 8) * 8 + static_cast<std::size_t>(p.v * 8)] += 1;
    }
    double chiSquare = 0;
    for (const double n : found) chiSquare += (n - kCount / 64.0) * (n - kCount / 64.0) / (kCount / 64.0);
    EXPECT_LT(chiSquare, 63 + 5 * 11.3);
    EXPECT_GT(chiSquare, 63 - 5 * 11.3);
}

// By another program. Images rest on all of them.
TEST(RandomBits, KeepTheirValues) {
    EXPECT_EQ(mixBits(1), 0x688990C0U);
    EXPECT_EQ(randomBits({3, 4, 5}, SampleDimension::Lens, 6), 0xDAA9738DU);
    EXPECT_EQ(randomBits({639, 479, 15}, SampleDimension::Shaft, 2), 0xBC0AEEF2U);
    const OwenPair pair = pairInSequence({3, 4, 5}, 9, SampleDimension::Direction, 2);
    EXPECT_EQ(pair.u, 0x7B661F51U);
    EXPECT_EQ(pair.v, 0x5CEEDDDFU);
}

} // namespace
} // namespace rtcore
