// Which points are one but for rounding, beside looking at all pairs.
#include "rtcore/scene/weld.h"

#include "support/random_numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtcore {
namespace {

using Indices = std::vector<std::uint32_t>;

/// One part: triangles that share two points each with the next.
Indices strip(std::size_t points) {
    Indices corners;
    for (std::uint32_t i = 0; i + 2 < points; ++i) corners.insert(corners.end(), {i, i + 1, i + 2});
    return corners;
}

DisjointSets joinedByPairs(const std::vector<Vec3>& points, const Indices& which, double apart) {
    DisjointSets sets(points.size());
    for (const std::uint32_t i : which) {
        for (const std::uint32_t k : which) {
            double max = 0;
            for (int axis = 0; axis < 3; ++axis)
                max = std::max(max, std::fabs(double{points[i][axis]} - double{points[k][axis]}));
            if (max <= apart) sets.join(i, k);
        }
    }
    return sets;
}

/// Whether points that are one in `finer` are one in `coarser`.
bool isWithin(DisjointSets finer, DisjointSets coarser, std::size_t points) {
    for (std::uint32_t i = 0; i < points; ++i) {
        if (coarser.find(i) != coarser.find(finer.find(i))) return false;
    }
    return true;
}

void expectWelded(const std::vector<Vec3>& points, Indices which, double tolerance) {
    const DisjointSets welded = weldPoints(points, strip(points.size()), which);
    EXPECT_TRUE(isWithin(joinedByPairs(points, which, 0.99 * tolerance), welded, points.size()));
    EXPECT_TRUE(isWithin(welded, joinedByPairs(points, which, 2.01 * tolerance), points.size()));
    std::reverse(which.begin(), which.end());
    const DisjointSets again = weldPoints(points, strip(points.size()), which);
    EXPECT_TRUE(isWithin(welded, again, points.size()) && isWithin(again, welded, points.size()));
}

Indices every(std::size_t step, std::size_t points) {
    Indices which;
    for (std::size_t i = 0; i < points; i += step) which.push_back(static_cast<std::uint32_t>(i));
    return which;
}

/// Within ±8 tolerances of a place, and two that make the part of size 1: anywhere or, in steps of half a
/// tolerance, on the borders of cells.
std::vector<Vec3> crowd(Vec3 place, double tolerance, double step, std::uint64_t seed) {
    test::Random random(seed);
    std::vector<Vec3> points{place, place + Vec3{1, 0, 0}};
    for (int i = 0; i < 200; ++i) {
        Vec3 p;
        for (int axis = 0; axis < 3; ++axis) {
            double off = random.number(-8, 8);
            if (step != 0) off = step * std::round(off / step);
            p[axis] = static_cast<float>(place[axis] + tolerance * off);
        }
        points.push_back(p);
    }
    return points;
}

TEST(Weld, JoinsWhatIsWithinTheToleranceAndNothingFarApart) {
    for (const float place : {0.0F, 0.3F, 1e4F, -1e9F}) {
        const double tolerance = std::max(1e-6, std::fabs(place) * 0x1p-22);
        for (const double step : {0.0, 0.5, 1.0, 2.0}) {
            for (std::uint64_t seed = 1; seed <= 3; ++seed) {
                SCOPED_TRACE(testing::Message() << place << ", steps of " << step);
                const std::vector<Vec3> points = crowd({place, place, -place}, tolerance, step, seed);
                for (const std::size_t chosen : {1U, 2U})
                    expectWelded(points, every(chosen, points.size()), tolerance);
            }
        }
    }
}

TEST(Weld, ManyInOnePlaceAreOneAndThoseThatWereNotChosenAlone) {
    constexpr std::size_t kPoints = 50'000;
    const std::vector<Vec3> points(kPoints, Vec3{0.5F, -2, 1e5F});
    DisjointSets same = weldPoints(points, strip(kPoints), every(2, kPoints));
    for (std::uint32_t i = 0; i < kPoints; ++i) ASSERT_EQ(same.find(i), i % 2 == 0 ? same.find(0) : i);
}

} // namespace
} // namespace rtcore
