#include "rtcore/sampling/lens_pattern.h"
#include "rtcore/sampling/pixel_pattern.h"
#include "rtcore/sampling/poisson_disc.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <vector>

namespace rtcore {
namespace {

constexpr SamplingPattern kPatterns[] = {SamplingPattern::Grid, SamplingPattern::Random,
                                         SamplingPattern::Jittered, SamplingPattern::Rotated,
                                         SamplingPattern::Poisson};

std::vector<SquarePoint> pixelOf(const PixelPattern& pattern, int n, int x, int y) {
    std::vector<SquarePoint> points;
    for (int sub = 0; sub < n * n; ++sub) {
        points.push_back(pattern.at(
            {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), static_cast<std::uint32_t>(sub)}));
    }
    return points;
}

TEST(PixelPattern, AllSamplesLieInTheirPixel) {
    for (const SamplingPattern kind : kPatterns) {
        for (int n = 1; n <= 16; ++n) {
            PixelPattern pattern;
            pattern.prepare(kind, n);
            for (int pixel = 0; pixel < 50; ++pixel) {
                for (const SquarePoint p : pixelOf(pattern, n, pixel * 7, 65535 - pixel)) {
                    ASSERT_TRUE(p.u >= 0 && p.u < 1 && p.v >= 0 && p.v < 1) << n;
                }
            }
        }
    }
}

TEST(PixelPattern, TheSameInEveryFrameButNotInEveryPixel) {
    for (const SamplingPattern kind : kPatterns) {
        PixelPattern one, other;
        one.prepare(kind, 3);
        other.prepare(kind, 5);
        other.prepare(kind, 3);
        const bool shared = kind == SamplingPattern::Grid || kind == SamplingPattern::Rotated;
        std::set<float> firsts;
        for (int x = 0; x < 20; ++x) {
            const auto a = pixelOf(one, 3, x, 4), b = pixelOf(other, 3, x, 4);
            for (std::size_t i = 0; i < a.size(); ++i) {
                EXPECT_EQ(a[i].u, b[i].u);
                EXPECT_EQ(a[i].v, b[i].v);
            }
            firsts.insert(a[0].u);
        }
        EXPECT_EQ(firsts.size(), shared ? 1U : 20U);
    }
}

TEST(PixelPattern, RotatedFour) {
    PixelPattern pattern;
    pattern.prepare(SamplingPattern::Rotated, 2);
    std::set<std::pair<float, float>> points;
    for (const SquarePoint p : pixelOf(pattern, 2, 0, 0)) points.insert({p.u, p.v});
    EXPECT_EQ(points, (std::set<std::pair<float, float>>{
                          {.125F, .375F}, {.375F, .875F}, {.625F, .125F}, {.875F, .625F}}));
}

TEST(PixelPattern, RotatedHasARowAndAColumnForEach) {
    for (int n = 1; n <= 16; ++n) {
        PixelPattern pattern;
        pattern.prepare(SamplingPattern::Rotated, n);
        std::set<int> columns, rows;
        for (const SquarePoint p : pixelOf(pattern, n, 3, 3)) {
            columns.insert(static_cast<int>(p.u * static_cast<float>(n * n)));
            rows.insert(static_cast<int>(p.v * static_cast<float>(n * n)));
        }
        EXPECT_EQ(columns.size(), static_cast<std::size_t>(n * n));
        EXPECT_EQ(rows.size(), static_cast<std::size_t>(n * n));
    }
}

TEST(PixelPattern, JitteredHasOneInEachCell) {
    PixelPattern pattern;
    pattern.prepare(SamplingPattern::Jittered, 5);
    const auto points = pixelOf(pattern, 5, 77, 5);
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_EQ(static_cast<std::size_t>(points[i].u * 5), i % 5);
        EXPECT_EQ(static_cast<std::size_t>(points[i].v * 5), i / 5);
    }
}

TEST(PoissonDisc, NeighboursAreFarApartOnTheTorus) {
    EXPECT_NEAR(largestPoissonDistance(16), .268642F, 1e-6F);
    for (int n = 2; n <= 16; ++n) {
        PixelPattern pattern;
        pattern.prepare(SamplingPattern::Poisson, n);
        const auto points = pixelOf(pattern, n, 12, 34); // shifted
        double nearest = 1;
        for (std::size_t i = 0; i < points.size(); ++i) {
            for (std::size_t k = 0; k < i; ++k) {
                const double u = std::fabs(points[i].u - points[k].u),
                             v = std::fabs(points[i].v - points[k].v);
                nearest = std::min(nearest, std::hypot(std::min(u, 1 - u), std::min(v, 1 - v)));
            }
        }
        EXPECT_GE(nearest, .7 * static_cast<double>(largestPoissonDistance(n * n))) << n;
    }
}

/// The share of the pixel where a x + b y < c.
double areaBelow(double a, double b, double c) {
    // Mirrored until both are positive: two right-angled triangles less what sticks out.
    if (a < 0) return areaBelow(-a, b, c - a);
    if (b < 0) return areaBelow(a, -b, c - b);
    const auto square = [](double x) { return x > 0 ? x * x : 0.0; };
    constexpr double kFlat = 1e-9;
    if (a < kFlat) return std::clamp(c / b, 0.0, 1.0);
    if (b < kFlat) return std::clamp(c / a, 0.0, 1.0);
    return (square(c) - square(c - a) - square(c - b) + square(c - a - b)) / (2 * a * b);
}

/// Root of the mean square error of a pixel with an edge through any point of it, `spread` degrees at most
/// from an axis.
double edgeError(SamplingPattern kind, int n, double spread) {
    PixelPattern pattern;
    pattern.prepare(kind, n);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0, 1);
    double sum = 0;
    constexpr int kEdges = 40000;
    for (int i = 0; i < kEdges; ++i) {
        const double quarter = std::floor(unit(random) * 4) * 90;
        const double angle = (quarter + (2 * unit(random) - 1) * spread) * 3.14159265358979 / 180;
        const double a = std::cos(angle), b = std::sin(angle);
        const double x = unit(random), c = a * x + b * unit(random);
        const auto points = pixelOf(pattern, n, i % 200, i / 200);
        const auto below = std::count_if(points.begin(), points.end(), [&](SquarePoint p) {
            return a * static_cast<double>(p.u) + b * static_cast<double>(p.v) < c;
        });
        const double error = static_cast<double>(below) / (n * n) - areaBelow(a, b, c);
        sum += error * error;
    }
    return std::sqrt(sum / kEdges);
}

TEST(PixelPattern, ErrorOfEdges) {
    constexpr double kAny = 45, kNearAxis = 5;
    EXPECT_NEAR(edgeError(SamplingPattern::Grid, 4, kAny), .033, .003);
    EXPECT_NEAR(edgeError(SamplingPattern::Grid, 4, kNearAxis), .061, .005);
    EXPECT_NEAR(edgeError(SamplingPattern::Jittered, 4, kAny), .049, .003);
    EXPECT_NEAR(edgeError(SamplingPattern::Jittered, 4, kNearAxis), .051, .003);
    EXPECT_NEAR(edgeError(SamplingPattern::Random, 4, kAny), .102, .003);
    EXPECT_NEAR(edgeError(SamplingPattern::Random, 4, kNearAxis), .103, .003);
    EXPECT_NEAR(edgeError(SamplingPattern::Rotated, 4, kAny), .036, .003);
    EXPECT_NEAR(edgeError(SamplingPattern::Rotated, 4, kNearAxis), .023, .003);
}

TEST(PixelPattern, TheirOrderAtEdges) {
    for (const int n : {3, 4, 6}) {
        const auto error = [n](SamplingPattern kind) { return edgeError(kind, n, 5); };
        EXPECT_LT(error(SamplingPattern::Rotated), error(SamplingPattern::Jittered)) << n;
        EXPECT_LT(error(SamplingPattern::Rotated), error(SamplingPattern::Grid)) << n;
        EXPECT_LT(error(SamplingPattern::Jittered), 0.7 * error(SamplingPattern::Random)) << n;
        EXPECT_LT(error(SamplingPattern::Poisson), 0.8 * error(SamplingPattern::Random)) << n;
    }
}

TEST(LensPattern, PermutationsMeetEachNumberOnce) {
    for (const std::uint32_t count : {1U, 2U, 4U, 9U, 16U, 81U, 225U, 256U}) {
        std::set<std::vector<std::uint32_t>> orders;
        for (const std::uint32_t key : {0U, 1U, 77U, 0xFFFFFFFFU, 0xFFFFFFF0U, 0x12345678U}) {
            std::vector<std::uint32_t> order;
            for (std::uint32_t i = 0; i < count; ++i) order.push_back(permuted(i, count, key));
            orders.insert(order);
            std::sort(order.begin(), order.end());
            for (std::uint32_t i = 0; i < count; ++i) ASSERT_EQ(order[i], i) << count << " " << key;
        }
        EXPECT_TRUE(count < 9 || orders.size() == 6) << count;
    }
}

/// The correlation of the samples' places in the pixel with those on the lens, and its spread.
TEST(LensPattern, IsSpreadEvenlyAndApartFromThePixel) {
    constexpr int n = 4;
    PixelPattern pixels;
    pixels.prepare(SamplingPattern::Rotated, n);
    LensPattern lens;
    lens.prepare(n);
    double correlation = 0, variance = 0;
    for (int pixel = 0; pixel < 1000; ++pixel) {
        double mean = 0;
        std::set<int> columns;
        const SampleId first{static_cast<std::uint16_t>(pixel), 9, 0};
        for (std::uint32_t sub = 0; sub < n * n; ++sub) {
            const SampleId id{first.x, first.y, sub};
            const SquarePoint p = lens.at(id);
            ASSERT_TRUE(p.u >= 0 && p.u < 1 && p.v >= 0 && p.v < 1);
            columns.insert(static_cast<int>(std::floor(
                wrapped(p.u, 1 - randomShift(first, SampleDimension::Lens).u) * (n * n)))); // shifted back
            mean += static_cast<double>(p.u) / (n * n);
            correlation += (static_cast<double>(p.u) - .5) * (static_cast<double>(pixels.at(id).u) - .5);
        }
        EXPECT_EQ(columns.size(), static_cast<std::size_t>(n * n)) << pixel;
        variance += (mean - .5) * (mean - .5) / 1000;
    }
    EXPECT_LT(std::fabs(correlation / 16000), .003); // a 25th of that of a sample with itself
    EXPECT_LT(variance, 1 / 12.0 / 256 * 1.05);      // at random: 1 / 12 / 16
}

} // namespace
} // namespace rtcore
