// Parts of a model that are hidden and shown.

#include "parted_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace rtcore {
namespace {

const std::vector<std::uint8_t> kHidden{1}, kShown{};

struct Opening {
    float width, height;
};
constexpr Opening kDoor{1, 2.1F}, kGate{2.5F, 2.6F};

/// Three rooms of 4 x 3 x 4 in a row along x, 10 cm apart; floor and ceiling run through. A light in the
/// first and in the last one; between the first two an opening with a leaf, which is the part.
Scene threeRooms(Opening opening) {
    test::SceneBuilder b;
    const auto white = b.material(test::matte(0.7F)), grey = b.material(test::matte(0.4F));
    const float from = 2 - opening.width / 2, to = 2 + opening.width / 2;
    b.box({4.02F, 0, from}, {4.08F, opening.height, to}, grey);
    b.buffers.parts = {{b.buffers.addName("leaf"), 0, 12}};
    test::addRoom(b, {0, 0, 0}, {12.2F, 3, 4}, white);
    b.box({4, 0, 0}, {4.1F, 3, from}, white);
    b.box({4, 0, to}, {4.1F, 3, 4}, white);
    b.box({4, opening.height, from}, {4.1F, 3, to}, white);
    b.box({8.1F, 0, 0}, {8.2F, 3, 4}, white);
    b.box({6.5F, 0, 0.5F}, {7.5F, 1, 1.5F}, grey);
    Scene scene = b.finish();
    scene.lights = {test::pointLight({1, 2.5F, 2}, 10), test::pointLight({10, 2.5F, 2}, 3)};
    return scene;
}

constexpr std::size_t kLit = 0, kBeside = 1, kElsewhere = 2, kRooms = 3;

void addReceivers(test::PartedScene& scene) {
    for (std::size_t room = 0; room < kRooms; ++room) {
        const float x = 4.1F * static_cast<float>(room);
        scene.addReceiversOfBox({x, 0, 0}, {x + 4, 3, 4}, 300, 0.004F);
    }
}

double meanOf(const std::vector<double>& light, std::size_t room) {
    const std::size_t count = light.size() / kRooms;
    double sum = 0;
    for (std::size_t i = room * count; i < (room + 1) * count; ++i) sum += light[i];
    return sum / static_cast<double>(count);
}
double meanDifference(const std::vector<double>& a, const std::vector<double>& b, std::size_t room) {
    const std::size_t count = a.size() / kRooms;
    double sum = 0;
    for (std::size_t i = room * count; i < (room + 1) * count; ++i) sum += std::abs(a[i] - b[i]);
    return sum / static_cast<double>(count);
}

/// Rooms whose light is known long since, and that of the state that they are brought to.
class PartsTest : public testing::Test {
  protected:
    void learnBoth(Opening opening, bool hidden) {
        test::PartedScene cold(threeRooms(opening), hidden ? kHidden : kShown);
        addReceivers(cold);
        cold.budget = {32768, 3000};
        cold.learn(200);
        truth = cold.shown();
        rooms = std::make_unique<test::PartedScene>(threeRooms(opening), hidden ? kShown : kHidden);
        rooms->receivers = cold.receivers;
        rooms->budget = {32768, 3000};
        rooms->learn(60);
        rooms->budget = {8192, 768};
        before = rooms->shown();
    }
    /// Steps on to that many, all of which leave the last room as it was.
    void stepTo(int step) {
        for (; done < step; ++done) {
            rooms->learn(1);
            const std::vector<double> now = rooms->shown();
            EXPECT_LT(meanDifference(now, before, kElsewhere), 0.02 * meanOf(before, kElsewhere)) << done;
        }
    }
    /// Of the mean light of a room, as a part of the larger of its light before and after.
    double error(std::size_t room) const {
        const double light = std::max(meanOf(before, room), meanOf(truth, room));
        const double wrong = (meanOf(rooms->shown(), room) - meanOf(truth, room)) / light;
        RecordProperty("room" + std::to_string(room) + "after" + std::to_string(done), std::to_string(wrong));
        return std::abs(wrong);
    }
    void expectToFollow() {
        stepTo(1);
        EXPECT_LT(error(kBeside), 0.2);
        EXPECT_LT(error(kLit), 0.06);
        stepTo(8);
        EXPECT_LT(error(kBeside), 0.06);
        EXPECT_LT(error(kLit), 0.06);
        stepTo(16);
        EXPECT_LT(error(kBeside), 0.02);
        EXPECT_LT(error(kLit), 0.02);
    }

    std::unique_ptr<test::PartedScene> rooms;
    std::vector<double> truth, before;
    int done = 0;
};

TEST_F(PartsTest, ADoorThatClosesLeavesItsRoomDark) {
    learnBoth(kDoor, false);
    ASSERT_LT(meanOf(truth, kBeside), 0.05 * meanOf(before, kBeside));
    rooms->hide(kShown);
    expectToFollow();
}

TEST_F(PartsTest, AGateThatClosesLeavesItsRoomDark) {
    learnBoth(kGate, false);
    rooms->hide(kShown);
    expectToFollow();
    stepTo(150);
    EXPECT_LT(meanOf(rooms->shown(), kBeside), 0.003 * meanOf(rooms->shown(), kLit)) << "nothing leaks";
}

TEST_F(PartsTest, AGateThatOpensLightsItsRoom) {
    learnBoth(kGate, true);
    rooms->hide(kHidden);
    expectToFollow();
}

TEST_F(PartsTest, OneThatIsTakenBackIsAsItWas) {
    learnBoth(kGate, true);
    rooms->hide(kHidden);
    stepTo(4);
    rooms->hide(kShown);
    stepTo(5);
    rooms->hide(kHidden);
    done = 0;
    expectToFollow();
}

/// A long corridor that goes round two corners; its light comes through a hatch at one end. From the other
/// one few paths find it: they must be many, lest their noise is all that is seen.
TEST(Parts, FarLightGoesWithTheHatchThatItComesThrough) {
    constexpr GatherBudget kMany{32768, 8192};
    test::SceneBuilder b;
    const auto white = b.material(test::matte(0.8F));
    b.box({0.5F, 2.5F, 0.5F}, {1, 2.52F, 1}, white);
    b.buffers.parts = {{b.buffers.addName("hatch"), 0, 12}};
    const auto wall = [&](Vec3 lo, Vec3 hi) { b.box(lo, hi, white); };
    wall({-0.1F, -0.1F, -0.1F}, {8.1F, 0, 6.1F}); // floor, then sides, then the ceiling around the hatch
    wall({-0.1F, 0, -0.1F}, {0, 2.5F, 6.1F});
    wall({8, 0, -0.1F}, {8.1F, 2.5F, 6.1F});
    wall({0, 0, -0.1F}, {8, 2.5F, 0});
    wall({0, 0, 6}, {8, 2.5F, 6.1F});
    wall({0, 0, 2}, {6, 2.5F, 4});
    wall({-0.1F, 2.5F, -0.1F}, {0.5F, 2.6F, 6.1F});
    wall({1, 2.5F, -0.1F}, {8.1F, 2.6F, 6.1F});
    wall({0.5F, 2.5F, -0.1F}, {1, 2.6F, 0.5F});
    wall({0.5F, 2.5F, 1}, {1, 2.6F, 6.1F});
    Scene scene = b.finish();
    Light sun;
    sun.kind = LightKind::Directional;
    sun.direction = {0.05F, -1, 0.05F};
    sun.intensity = {50, 50, 50};
    scene.lights = {sun};
    test::PartedScene corridor(std::move(scene), kHidden);
    corridor.addReceiversOfBox({0, 0, 0}, {8, 2.5F, 2}, 150, 0.004F);
    const std::size_t near = corridor.receivers.size();
    corridor.addReceiversOfBox({0, 0, 4}, {8, 2.5F, 6}, 150, 0.004F);
    corridor.budget = kMany;
    corridor.learn(120);
    const std::vector<double> before = corridor.shown();
    corridor.budget = {8192, 768};
    corridor.hide(kShown);
    corridor.learn(8);
    const std::vector<double> dark = corridor.shown();
    const auto sumOf = [&](const std::vector<double>& light, bool far) {
        double sum = 0;
        for (std::size_t i = far ? near : 0; i < (far ? light.size() : near); ++i) sum += light[i];
        return sum;
    };
    EXPECT_GT(sumOf(before, true), 0);
    for (const bool far : {false, true}) {
        EXPECT_LT(sumOf(dark, far), 0.06 * sumOf(before, far)) << far;
    }
    corridor.hide(kHidden);
    corridor.learn(8);
    corridor.budget = kMany;
    corridor.learn(120);
    const std::vector<double> again = corridor.shown();
    for (const bool far : {false, true}) EXPECT_NEAR(sumOf(again, far) / sumOf(before, far), 1, 0.15) << far;
}

IndirectState stateAfterEdits(int threads) {
    test::PartedScene rooms(threeRooms(kDoor), kShown);
    rooms.threads = threads;
    rooms.addReceiversOfBox({0, 0, 0}, {8.1F, 3, 4}, 200, 0.006F);
    rooms.learn(6, 600);
    rooms.hide(kHidden);
    rooms.learn(2, 600);
    rooms.hide(kShown);
    return rooms.light.state();
}

TEST(Parts, TheSameBitsForAllThreads) {
    const IndirectState expected = stateAfterEdits(1);
    EXPECT_EQ(checkIndirectState(expected), std::nullopt);
    for (const int threads : {2, 7}) EXPECT_EQ(stateAfterEdits(threads), expected) << threads;
}

TEST(Parts, RecordsOnThemGoWithThem) {
    test::PartedScene rooms(threeRooms(kGate), kShown);
    rooms.addReceiversOfBox({0, 0, 0}, {4.02F, 3, 4}, 200, 0.006F); // the leaf is a part of this box's side
    rooms.learn(5, 1000);
    const auto onLeaf = [&] {
        int count = 0;
        for (std::uint32_t i = 0; i < rooms.light.cache().size(); ++i) {
            const Vec3 at = rooms.light.cache().record(i).position;
            count += at.x > 4.01F && at.y < kGate.height && std::abs(at.z - 2) < kGate.width / 2 ? 1 : 0;
        }
        return count;
    };
    EXPECT_GT(onLeaf(), 10);
    rooms.hide(kHidden);
    EXPECT_EQ(onLeaf(), 0);
    const std::size_t kept = rooms.light.cache().size();
    EXPECT_GT(kept, 0U);
    rooms.hide(kHidden);
    EXPECT_EQ(rooms.light.cache().size(), kept) << "nothing is changed";
}

TEST(Parts, BeforeAnythingIsLearnedChangeNothing) {
    test::PartedScene rooms(threeRooms(kDoor), kShown);
    rooms.hide(kHidden);
    EXPECT_EQ(rooms.light.cache().size(), 0U);
    rooms.addReceiversOfBox({0, 0, 0}, {4, 3, 4}, 100, 0.006F);
    rooms.learn(2);
    EXPECT_GT(meanOf(rooms.shown(), 0), 0.1);
}

} // namespace
} // namespace rtcore
