// Light stays on its side of walls.

#include "gathering_support.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace rtcore {
namespace {

/// Two rooms of 4 x 3 x 4, side by side along x, with a wall of 2 cm between them; floor and ceiling run
/// through. A light in the first.
Scene twoRooms(float parted) {
    test::SceneBuilder b;
    const auto white = b.material(test::matte(0.7F));
    if (parted > 0) {
        test::addRoom(b, {0, 0, 0}, {4, 3, 4}, white);
        test::addRoom(b, {4 + parted, 0, 0}, {8, 3, 4}, white);
    } else {
        test::addRoom(b, {0, 0, 0}, {8, 3, 4}, white);
        b.box({4, 0, 0}, {4.02F, 3, 4}, white);
    }
    Scene scene = b.finish();
    scene.lights = {test::pointLight({1.5F, 2.5F, 2}, 10)};
    return scene;
}

/// The mean of a room's receivers, and of those 2 mm to 3 cm from the wall.
struct OfRoom {
    double mean = 0, atWall = 0;
};
OfRoom lightOf(const test::GatheringScene& scene, bool dark) {
    OfRoom room;
    int all = 0, near = 0;
    for (const Receiver& receiver : scene.receivers) {
        if ((receiver.position.x > 4.01F) != dark) continue;
        const double light = scene.at(receiver).r;
        room.mean += light;
        ++all;
        if (std::abs(receiver.position.x - 4.01F) > 0.04F) continue;
        room.atWall += light;
        ++near;
    }
    room.mean /= all;
    room.atWall /= std::max(near, 1);
    return room;
}

void addReceivers(test::GatheringScene& scene, float wall) {
    for (const float from : {0.0F, 4 + wall}) {
        const Vec3 lo{from, 0, 0}, hi{from == 0 ? 4.0F : 8.0F, 3, 4};
        scene.addReceiversOfBox(lo, hi, 700, 0.004F);
        const float x = from == 0 ? 3.97F : from + 0.002F; // a stripe at the foot of the wall
        scene.addReceivers({x, 0, 0}, {0.028F, 0, 0}, {0, 0, 4}, {0, 1, 0}, 200, 0.004F);
    }
}

TEST(LeaksOfLight, AWallOfTwoCentimetresKeepsARoomDark) {
    test::GatheringScene rooms(twoRooms(0));
    addReceivers(rooms, 0.02F);
    rooms.budget = {16384, 1536};
    rooms.learn(230);
    const OfRoom lit = lightOf(rooms, false), dark = lightOf(rooms, true);
    EXPECT_GT(lit.mean, 0.5);
    EXPECT_LT(dark.mean, 0.002 * lit.mean);
    EXPECT_LT(dark.atWall, 0.004 * lit.mean);
}

TEST(LeaksOfLight, RoomsThatAreApartGetNothing) {
    test::GatheringScene rooms(twoRooms(0.02F));
    addReceivers(rooms, 0.02F);
    rooms.learn(30);
    const OfRoom lit = lightOf(rooms, false), dark = lightOf(rooms, true);
    EXPECT_GT(lit.mean, 0.5);
    EXPECT_EQ(dark.mean, 0);
}

TEST(LeaksOfLight, AClosedCupboardIsBlackInside) {
    test::SceneBuilder b;
    const auto white = b.material(test::matte(0.8F));
    test::addRoom(b, {0, 0, 0}, {4, 3, 4}, white);
    b.box({0.5F, 0.01F, 0.5F}, {1.1F, 2, 1}, white);
    test::addRoom(b, {0.52F, 0.03F, 0.52F}, {1.08F, 1.98F, 0.98F}, white);
    Scene scene = b.finish();
    scene.lights = {test::pointLight({2, 2.5F, 2}, 10)};
    test::GatheringScene room(std::move(scene));
    room.addReceiversOfBox({0, 0, 0}, {4, 3, 4}, 500, 0.004F);
    const std::size_t ofRoom = room.receivers.size();
    room.addReceiversOfBox({0.52F, 0.03F, 0.52F}, {1.08F, 1.98F, 0.98F}, 500, 0.002F);
    room.learn(30);
    EXPECT_GT(room.at(room.receivers[0]).r, 0.1);
    for (std::size_t i = ofRoom; i < room.receivers.size(); ++i)
        EXPECT_EQ(room.at(room.receivers[i]).r, 0) << i;
}

} // namespace
} // namespace rtcore
