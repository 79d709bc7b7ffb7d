// Areas that solids cover together, and rooms between walls, against areas that are known.
#include "rtcore/plans/flat_areas.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {

using namespace rtcore;

constexpr Openings kOpenings{.door = 1.2, .window = 3};
constexpr RoomBounds kBounds{.area = 1, .width = 0.6};

FlatLoop rectangle(double left, double low, double right, double high) {
    return {{left, low}, {right, low}, {right, high}, {left, high}};
}

FlatLoop reversed(const FlatLoop& loop) { return {loop.rbegin(), loop.rend()}; }

CutOutline outline(std::vector<FlatLoop> loops, bool closed = true) {
    return {0, 0, closed, std::move(loops), {}};
}

double areaOfAll(const std::vector<FlatLoop>& loops) {
    double sum = 0;
    for (const FlatLoop& loop : loops) sum += areaOf(loop);
    return sum;
}

std::vector<RoomArea> roomsIn(const std::vector<FlatLoop>& walls, const std::vector<FlatLoop>& lines = {}) {
    return roomsBetween(walls, lines, kOpenings, kBounds);
}

FlatLoop turned(FlatLoop loop, double angle, FlatPoint shift) {
    for (FlatPoint& p : loop)
        p = {shift[0] + p[0] * std::cos(angle) - p[1] * std::sin(angle),
             shift[1] + p[0] * std::sin(angle) + p[1] * std::cos(angle)};
    return loop;
}

TEST(CoveredBy, CountsOverlapsOnceWhicheverWayTheyWind) {
    const FlatLoop one = rectangle(0, 0, 2, 2), other = rectangle(1, 1, 3, 3);
    EXPECT_NEAR(areaOfAll(coveredBy({outline({one}), outline({reversed(other)})})), 7, 1e-9);
    EXPECT_NEAR(areaOfAll(coveredBy({outline({one}), outline({one})})), 4, 1e-9);
}

TEST(CoveredBy, KeepsHollowsAndLeavesOpenPartsOut) {
    const CutOutline tube = outline({rectangle(0, 0, 4, 4), reversed(rectangle(1, 1, 3, 3))});
    EXPECT_NEAR(areaOfAll(coveredBy({tube})), 12, 1e-9);
    const CutOutline core = outline({rectangle(1.5, 1.5, 2.5, 2.5)});
    EXPECT_NEAR(areaOfAll(coveredBy({tube, core})), 13, 1e-9) << "a rod in the tube";
    EXPECT_NEAR(areaOfAll(coveredBy({tube, outline({rectangle(5, 0, 6, 1)}, false)})), 12, 1e-9);
    EXPECT_TRUE(coveredBy({}).empty());
}

// Walls of .2 around 6 x 4 m, parted at x = 4 with a door of .9 m.
std::vector<FlatLoop> twoRooms() {
    return {rectangle(-.2, -.2, 6.2, 0), rectangle(-.2, 4, 6.2, 4.2), rectangle(-.2, 0, 0, 4),
            rectangle(6, 0, 6.2, 4),     rectangle(4, 0, 4.1, 2),     rectangle(4, 2.9, 4.1, 4)};
}

TEST(RoomsBetween, ADoorPartsTwo) {
    const std::vector<RoomArea> rooms = roomsIn(twoRooms());
    ASSERT_EQ(rooms.size(), 2U);
    EXPECT_NEAR(rooms[0].area, 4 * 4, 1e-6);
    EXPECT_NEAR(rooms[1].area, 1.9 * 4, 1e-6);
    EXPECT_NEAR(rooms[0].label[0], 2, 0.2);
    EXPECT_NEAR(rooms[0].label[1], 2, 0.2);
    EXPECT_NEAR(areaOf(rooms[1].outline), 1.9 * 4, 1e-6) << "anticlockwise";
    // One where doors part nothing; the leaf of the door's width in the wall belongs to it.
    const std::vector<RoomArea> one = roomsBetween(twoRooms(), {}, {.door = 0, .window = 3}, kBounds);
    ASSERT_EQ(one.size(), 1U);
    EXPECT_NEAR(one[0].area, 6 * 4 - .1 * 3.1, 1e-4);
}

TEST(RoomsBetween, AreTheSameTurnedAndFarAway) {
    for (const double angle : {0.3, 1.1, 2.6}) {
        std::vector<FlatLoop> walls;
        for (const FlatLoop& wall : twoRooms()) walls.push_back(turned(wall, angle, {4.5e5, 5.4e6}));
        const std::vector<RoomArea> rooms = roomsIn(walls);
        ASSERT_EQ(rooms.size(), 2U) << angle;
        EXPECT_NEAR(rooms[0].area, 4 * 4, 1e-4 * 16) << angle;
        EXPECT_NEAR(rooms[1].area, 1.9 * 4, 1e-4 * 7.6) << angle;
    }
}

// A small room, narrower than its door of the wall is wide, and an entrance and a window outside.
TEST(RoomsBetween, OpeningsToTheOutsideAreClosed) {
    std::vector<FlatLoop> walls = twoRooms();
    walls[0] = rectangle(-.2, -.2, 1, 0);
    walls.push_back(rectangle(1.9, -.2, 6.2, 0)); // an entrance of .9
    walls[3] = rectangle(6, 0, 6.2, .9);
    walls.push_back(rectangle(6, 2.5, 6.2, 4)); // a window of 1.6
    const std::vector<RoomArea> rooms = roomsIn(walls);
    ASSERT_EQ(rooms.size(), 2U);
    EXPECT_NEAR(rooms[0].area, 16, 1e-6);
    EXPECT_NEAR(rooms[1].area, 7.6, 1e-6);
}

TEST(RoomsBetween, AnOpenSideOrPostsMakeNone) {
    std::vector<FlatLoop> walls = twoRooms();
    walls.erase(walls.begin()); // 6 m open
    EXPECT_TRUE(roomsIn(walls).empty());
    std::vector<FlatLoop> posts;
    for (int i = 0; i < 6; ++i)
        for (int k = 0; k < 6; ++k) posts.push_back(rectangle(2.5 * i, 2.5 * k, 2.5 * i + .3, 2.5 * k + .3));
    EXPECT_TRUE(roomsIn(posts).empty());
    EXPECT_TRUE(roomsIn({}).empty());
}

TEST(RoomsBetween, WhatStandsInARoomIsNoPartOfIt) {
    std::vector<FlatLoop> walls = twoRooms();
    walls.push_back(rectangle(1.8, 1.8, 2.2, 2.2));
    const std::vector<RoomArea> rooms = roomsIn(walls);
    ASSERT_EQ(rooms.size(), 2U);
    EXPECT_NEAR(rooms[0].area, 16 - .16, 1e-6);
    ASSERT_EQ(rooms[0].islands.size(), 1U);
    EXPECT_NEAR(areaOf(rooms[0].islands[0]), -.16, 1e-6);
}

// The skins of a wall of 8 x 0.3 m, and a small room of 1.2 x 0.9 m.
TEST(RoomsBetween, TheInsideOfAWallIsNone) {
    const auto closed = [](FlatLoop loop) {
        loop.push_back(loop.front());
        return loop;
    };
    const std::vector<RoomArea> rooms =
        roomsIn({}, {closed(rectangle(0, 0, 8, .3)), closed(rectangle(0, 2, 1.2, 2.9))});
    ASSERT_EQ(rooms.size(), 1U);
    EXPECT_NEAR(rooms[0].area, 1.08, 1e-3);
}

TEST(RoomsBetween, AThingHasNone) {
    EXPECT_TRUE(roomsIn({rectangle(0, 0, 1e-9, 1e-9), rectangle(2e-9, 0, 3e-9, 1e-9)}).empty());
}

// An L of 6 x 4 less 3 x 2, whose walls are lines; and a triangle.
TEST(RoomsBetween, LinesEncloseThemToo) {
    const FlatLoop ell{{0, 0}, {6, 0}, {6, 2}, {3, 2}, {3, 4}, {0, 4}, {0, 0}};
    std::vector<RoomArea> rooms = roomsIn({}, {ell});
    ASSERT_EQ(rooms.size(), 1U);
    EXPECT_NEAR(rooms[0].area, 18, 1e-3);
    const FlatLoop triangle{{0, 0}, {6, 0}, {0, 5}, {0, 0}};
    rooms = roomsIn({}, {triangle});
    ASSERT_EQ(rooms.size(), 1U);
    EXPECT_NEAR(rooms[0].area, 15, 1e-3);
}

} // namespace
