// Parts, lights and materials of buildings of several shapes that are edited while one walks in them.
// RT_BUILDINGS=SEED: all buildings and edits, by these random numbers (check-long.sh).

#include "edited_rooms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rtcore {
namespace {

using LightOfRooms = std::vector<std::vector<double>>;

LightOfRooms shownAt(const IndirectLight& light, const std::vector<std::vector<Receiver>>& points) {
    LightOfRooms shown;
    for (const std::vector<Receiver>& ofRoom : points) {
        std::vector<ArrivingLight> arriving(ofRoom.size());
        light.cache().lookUp(ofRoom, arriving);
        shown.emplace_back();
        for (const ArrivingLight& each : arriving) shown.back().push_back(each.irradiance.g);
    }
    return shown;
}

double meanOfRoom(const std::vector<double>& light) {
    double sum = 0;
    for (const double each : light) sum += each;
    return sum / static_cast<double>(light.size());
}

/// Other random numbers of what is seen, and all buildings: for long checks alone.
const char* wantedSeed() { return std::getenv("RT_BUILDINGS"); }

/// So much the mean light of a room may be off after 8 and 16 steps, as a part of the larger of its light
/// before and after.
struct Bounds {
    double after8 = 0.06, after16 = 0.02;
    double ofLit = 0.02; ///< after 16 steps, of rooms that had light, and have
};
/// Of rooms that were dark: what few paths found first is shown for long.
constexpr Bounds kOfOpened{0.15, 0.06}, kOfDim{0.2, 0.15};
/// Where all, or all of the rooms, learn anew.
constexpr Bounds kOfEmitter{0.06, 0.03, 0.03}, kOfLights{0.06, 0.04, 0.04};

/// Rooms whose light is known in two states, between which they are edited.
class EditedRooms : public testing::Test {
  protected:
    using Edit = std::function<void(test::EditedBuilding&)>;

    /// Learns the light of both.
    void learn(const test::Building& a, bool hiddenInA, const test::Building& b, bool hiddenInB) {
        inA.emplace(a, hiddenInA);
        inB.emplace(b, hiddenInB);
        points = test::seenInBoth(*inA, *inB);
        for (test::EditedBuilding* const rooms : {&*inA, &*inB}) {
            if (wantedSeed() != nullptr)
                rooms->parted.random = test::Random(static_cast<std::uint64_t>(std::atoi(wantedSeed())));
            rooms->parted.budget = {.rays = 32768, .paths = 8192};
            rooms->parted.learn(50, 3000);
            rooms->parted.budget = {.rays = 8192, .paths = 768, .compared = 256};
        }
        ofA = shownAt(inA->parted.light, points);
        ofB = shownAt(inB->parted.light, points);
    }
    /// Brings rooms from A to B, or back.
    void expectToFollow(bool back, const Edit& edit, const Bounds& bounds, bool eachPoint = true) {
        test::EditedBuilding& rooms = back ? *inB : *inA;
        const LightOfRooms &before = back ? ofB : ofA, &truth = back ? ofA : ofB;
        edit(rooms);
        const std::string when = back ? "back after " : "after ";
        rooms.parted.learn(8);
        expectBounds(rooms, before, truth, {bounds.after8, Bounds{}.after8}, eachPoint, when + "8");
        rooms.parted.learn(8);
        expectBounds(rooms, before, truth, {bounds.after16, bounds.ofLit}, eachPoint, when + "16");
    }
    struct BoundsNow {
        double beside, lit;
    };
    /// Of rooms elsewhere it is the light before that stays.
    void expectBounds(const test::EditedBuilding& rooms, const LightOfRooms& before,
                      const LightOfRooms& truth, const BoundsNow& bounds, bool eachPoint,
                      const std::string& when) {
        const LightOfRooms now = shownAt(rooms.parted.light, points);
        for (std::size_t room = 0; room < points.size(); ++room) {
            const std::string name = "room " + std::to_string(room) + " " + when;
            const double was = meanOfRoom(before[room]), is = meanOfRoom(truth[room]);
            const bool elsewhere = rooms.kind(room) == test::RoomKind::Elsewhere;
            const double wrong = (meanOfRoom(now[room]) - (elsewhere ? was : is)) / std::max(was, is);
            RecordProperty(name, std::to_string(wrong));
            const double bound = rooms.kind(room) == test::RoomKind::Lit ? bounds.lit : bounds.beside;
            // Where all records learn anew rooms elsewhere do, too.
            EXPECT_LT(std::abs(wrong), elsewhere && eachPoint ? 0.02 : bound) << name;
            if (!elsewhere || !eachPoint) continue;
            double change = 0;
            for (std::size_t i = 0; i < points[room].size(); ++i)
                change += std::abs(now[room][i] - before[room][i]);
            EXPECT_LT(change / static_cast<double>(points[room].size()), 0.02 * was) << name;
        }
    }
    /// Hides the part of a building, and shows it.
    void hideAndShow(const test::Building& of, const Bounds& hidden, const Bounds& shown) {
        learn(of, false, of, true);
        expectToFollow(
            false, [](test::EditedBuilding& rooms) { rooms.hide(true); }, hidden);
        expectToFollow(
            true, [](test::EditedBuilding& rooms) { rooms.hide(false); }, shown);
    }
    /// Changes lights or materials of one whose part is hidden.
    void change(const test::Building& of, const std::function<void(Scene&)>& edit) {
        test::Building after = of;
        edit(after.scene);
        learn(of, true, after, true);
        const auto applied = [&](test::EditedBuilding& rooms) {
            Scene now = rooms.parted.scene();
            edit(now);
            rooms.change(std::move(now));
        };
        expectToFollow(false, applied, kOfLights, false);
    }

    std::optional<test::EditedBuilding> inA, inB;
    std::vector<std::vector<Receiver>> points; ///< by room
    LightOfRooms ofA, ofB;
};

using OpenedRooms = test::Building (*)();
class EditsOfRooms : public EditedRooms, public testing::WithParamInterface<OpenedRooms> {};

TEST_P(EditsOfRooms, FollowWhatOpensAndCloses) {
    const test::Building building = GetParam()();
    if (wantedSeed() == nullptr && !building.isUsual) GTEST_SKIP() << "RT_BUILDINGS is not set";
    hideAndShow(building, building.dimOnceOpen ? kOfDim : kOfOpened, {});
}
INSTANTIATE_TEST_SUITE_P(Of, EditsOfRooms,
                         testing::Values(test::roomsWithADoor, test::roomWithACorner, test::twoStoreys,
                                         test::roomWithACupboard, test::rowOfRooms, test::roomWithAShutter),
                         [](const auto& each) { return each.param().name; });

TEST_F(EditedRooms, AnEmitterOfFewTrianglesLeavesOthersAlone) {
    if (wantedSeed() == nullptr) GTEST_SKIP() << "RT_BUILDINGS is not set";
    hideAndShow(test::roomsOfEmitters(0), kOfEmitter, kOfEmitter);
}
TEST_F(EditedRooms, AnEmitterOfManyTrianglesLeavesOthersAlone) {
    hideAndShow(test::roomsOfEmitters(5), kOfEmitter, kOfEmitter);
}

/// All records learn anew; their mean is right, also elsewhere.
TEST_F(EditedRooms, LightsThatAreSwitched) {
    if (wantedSeed() == nullptr) GTEST_SKIP() << "RT_BUILDINGS is not set";
    change(test::roomsWithADoor(), [](Scene& scene) { scene.lights[0].light.on = 0; });
}
TEST_F(EditedRooms, LightsThatAreRecoloured) {
    if (wantedSeed() == nullptr) GTEST_SKIP() << "RT_BUILDINGS is not set";
    change(test::roomsWithADoor(), [](Scene& scene) { scene.lights[0].light.intensity = {9, 4, 1}; });
}
TEST_F(EditedRooms, LightsThatAreMoved) {
    change(test::roomsWithADoor(), [](Scene& scene) { scene.lights[0].light.position = {2.5F, 2, 3}; });
}
TEST_F(EditedRooms, MaterialsThatChange) {
    if (wantedSeed() == nullptr) GTEST_SKIP() << "RT_BUILDINGS is not set";
    change(test::roomWithACupboard(), [](Scene& scene) { scene.materials[1].diffuse = {0.1F, 0.2F, 0.4F}; });
}

/// Spread over steps, and stopped now and then, edits end in the same bits.
IndirectState stateAfter(std::uint32_t compared, bool stopped, int threads) {
    test::EditedBuilding rooms(test::roomWithACupboard(), false);
    rooms.parted.threads = threads;
    rooms.parted.learn(6, 600);
    rooms.hide(true);
    rooms.parted.budget.compared = compared;
    IndirectLight& light = rooms.parted.light;
    std::vector<Receiver> none;
    std::vector<ArrivingLight> arriving;
    for (int step = 0; light.changing(); ++step) {
        if (stopped) {
            const std::atomic<bool> stop{true};
            EXPECT_FALSE(light.step(none, arriving, rooms.parted.budget, threads, &stop));
        }
        EXPECT_TRUE(
            light.step(none, arriving, {.rays = 0, .paths = 0, .enough = 1, .compared = compared}, threads));
    }
    IndirectState state = light.state();
    state.frame = 0;
    for (OutgoingCells::Cell& cell : state.cells) cell.frame = 0;
    return state;
}

TEST(EditsOfParts, EndInTheSameBitsHoweverTheyAreSpread) {
    const IndirectState atOnce = stateAfter(100'000, false, 2);
    EXPECT_EQ(stateAfter(256, false, 1), atOnce);
    EXPECT_EQ(stateAfter(512, true, 2), atOnce);
}

TEST(EditsOfParts, ThatAreTakenBackBeforeTheyAreKnownLeaveTheLight) {
    test::EditedBuilding rooms(test::roomsOfEmitters(5), false);
    rooms.parted.learn(20, 600);
    const std::vector<std::vector<Receiver>> points{rooms.seen(2, 500)};
    const LightOfRooms before = shownAt(rooms.parted.light, points);
    rooms.parted.budget.compared = 256;
    rooms.hide(true);
    rooms.parted.learn(2, 600);
    EXPECT_TRUE(rooms.parted.light.changing());
    rooms.hide(false);
    EXPECT_FALSE(rooms.parted.light.changing());
    const LightOfRooms after = shownAt(rooms.parted.light, points);
    double change = 0;
    for (std::size_t i = 0; i < points[0].size(); ++i) change += std::abs(after[0][i] - before[0][i]);
    EXPECT_LT(change / static_cast<double>(points[0].size()), 0.01 * meanOfRoom(before[0]));
}

/// Stopped when all is judged, and records are about to learn what they forgot, one is no more to be undone.
TEST(EditsOfParts, ThatAreTakenBackOnceTheyAreKnownAreEditsOfTheirOwn) {
    constexpr GatherBudget kOfPart{.rays = 0, .paths = 0, .enough = 1, .compared = 1};
    const std::atomic<bool> stop{true};
    std::vector<Receiver> none;
    std::vector<ArrivingLight> arriving;
    const auto begin = [](test::EditedBuilding& rooms) {
        rooms.parted.learn(6, 600);
        rooms.hide(true);
    };
    test::EditedBuilding first(test::roomWithACupboard(), false), rooms(test::roomWithACupboard(), false);
    begin(first);
    begin(rooms);
    int steps = 0;
    for (; first.parted.light.changing(); ++steps)
        EXPECT_TRUE(first.parted.light.step(none, arriving, kOfPart, 0));
    IndirectLight& light = rooms.parted.light;
    for (int step = 1; step < steps; ++step) EXPECT_TRUE(light.step(none, arriving, kOfPart, 0));
    EXPECT_FALSE(light.step(none, arriving, kOfPart, 0, &stop));
    rooms.hide(false);
    EXPECT_TRUE(light.changing());
    while (light.changing()) EXPECT_TRUE(light.step(none, arriving, kOfPart, 0));
    EXPECT_EQ(checkIndirectState(light.state()), std::nullopt);
}

} // namespace
} // namespace rtcore
