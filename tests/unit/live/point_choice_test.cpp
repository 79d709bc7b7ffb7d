#include "rtcore/live/point_choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

namespace rtcore {
namespace {

constexpr int kColumns = 96, kRows = 80;

/// A lit surface, dark on the left and bright on the right, all of whose light is from half a pixel away.
LiveImage image() {
    LiveImage result;
    result.plane.width = kColumns;
    result.plane.height = kRows;
    result.points.resize(static_cast<std::size_t>(kColumns) * kRows);
    for (int y = 0; y < kRows; ++y) {
        for (int x = 0; x < kColumns; ++x) {
            LivePoint& point = result.at(x, y);
            point.depth = 1;
            point.flags = LivePoint::kLit;
            point.across = static_cast<std::int8_t>(kOffsetSteps / 2);
            point.light = packLight(x < kColumns / 2 ? Colour{0.1F, 0.1F, 0.1F} : Colour{1, 1, 1});
        }
    }
    return result;
}

std::set<std::pair<int, int>> chosen(const LiveImage& points, double share, std::uint32_t number,
                                     int threads = 1) {
    PointChoice choice;
    choice.choose(points, share, number, threads);
    std::set<std::pair<int, int>> result;
    for (const SampleId& id : choice.chosen()) EXPECT_TRUE(result.insert({id.x, id.y}).second);
    return result;
}

TEST(PointChoice, TakesUnknownPointsFirst) {
    LiveImage points = image();
    for (const int x : {3, 40, 77}) points.at(x, 50) = {};
    const auto found = chosen(points, 0.01, 5);
    for (const int x : {3, 40, 77}) EXPECT_TRUE(found.contains({x, 50}));
}

TEST(PointChoice, TakesPointsBesideOtherLightNext) {
    const auto found = chosen(image(), 0.02, 0);
    EXPECT_GE(found.size(), 100U);
    for (const auto& [x, y] : found) EXPECT_NEAR(x, kColumns / 2 - 0.5, 0.6) << y;
}

TEST(PointChoice, TakesAboutAsManyAsItMay) {
    for (const double share : {0.001, 0.03, 0.1, 0.5}) {
        const double count = share * kColumns * kRows;
        EXPECT_NEAR(static_cast<double>(chosen(image(), share, 3).size()), count, 8 + 0.2 * count) << share;
    }
    EXPECT_TRUE(chosen(image(), 0, 3).empty());
    EXPECT_EQ(chosen(image(), 1, 3).size(), static_cast<std::size_t>(kColumns) * kRows);
}

TEST(PointChoice, LeavesLightThatWasJustTraced) {
    LiveImage points = image();
    for (LivePoint& point : points.points) point.across = 0;
    EXPECT_TRUE(chosen(points, 1, 0).empty());
}

TEST(PointChoice, InTimeTakesEachPoint) {
    LiveImage points = image();
    for (LivePoint& point : points.points) point.light = packLight({1, 1, 1});
    std::set<std::pair<int, int>> all;
    for (std::uint32_t number = 0; number < kTurns; ++number) all.merge(chosen(points, 1.0 / 16, number));
    EXPECT_EQ(all.size(), points.points.size());
}

TEST(PointChoice, IsTheSameForAnyNumberOfThreads) {
    const LiveImage points = image();
    PointChoice one;
    one.choose(points, 0.13, 9, 1);
    for (const int threads : {2, 7}) {
        PointChoice other;
        other.choose(points, 0.13, 9, threads);
        ASSERT_EQ(one.chosen().size(), other.chosen().size());
        for (std::size_t i = 0; i < one.chosen().size(); ++i) {
            EXPECT_EQ(one.chosen()[i].x, other.chosen()[i].x);
            EXPECT_EQ(one.chosen()[i].y, other.chosen()[i].y);
        }
    }
}

TEST(PointChoice, SaysHowManyAreUnknown) {
    LiveImage points = image();
    for (int x = 0; x < kColumns; ++x) points.at(x, 7) = {};
    PointChoice choice;
    choice.choose(points, 0.1, 0, 1);
    EXPECT_NEAR(choice.unknown(), 1.0 / kRows, 1e-9);
}

} // namespace
} // namespace rtcore
