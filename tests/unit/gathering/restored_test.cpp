// Light that is taken up again where it was left.

#include "gathering_support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <span>

namespace rtcore {
namespace {

/// In which only a part of what is seen is looked at in each step.
class Walk {
  public:
    explicit Walk(Scene scene = test::furnishedRoom()) : room(std::move(scene)) {
        room.addReceiversOfBox({0, 0, 0}, {4, 3, 4}, 400, 0.006F);
        room.budget = {4096, 700};
    }
    /// The same steps whichever walk does them.
    std::vector<Colour> steps(int from, int to) {
        std::vector<Colour> light;
        std::vector<ArrivingLight> arriving(600);
        for (int step = from; step < to; ++step) {
            const std::size_t first = static_cast<std::size_t>(step) * 300 % 1800;
            room.light.step(std::span(room.receivers).subspan(first, 600), arriving, room.budget, 2);
            for (const ArrivingLight& each : arriving) light.push_back(each.irradiance);
        }
        return light;
    }

    test::GatheringScene room;
};

TEST(Restored, GoesOnWithTheSameBits) {
    Walk walk;
    walk.steps(0, 12);
    const IndirectState state = walk.room.light.state();
    EXPECT_EQ(checkIndirectState(state), std::nullopt);
    EXPECT_GT(state.irradiance.records.size(), 200U);
    EXPECT_TRUE(std::ranges::any_of(state.passes.histories,
                                    [](const RecordHistory& each) { return each.shrink < 1; }));
    Walk restored;
    restored.steps(20, 23); // whatever it knew is gone
    restored.room.light.restore(state);
    EXPECT_EQ(restored.room.light.state(), state);
    EXPECT_EQ(restored.steps(12, 24), walk.steps(12, 24));
    EXPECT_EQ(restored.room.light.state(), walk.room.light.state());
}

TEST(Restored, GoesOnWithTheSameBitsAfterRecordsWereForgotten) {
    Walk walk, restored;
    walk.room.light.boundRecords(300);
    restored.room.light.boundRecords(300);
    walk.steps(0, 30);
    restored.room.light.restore(walk.room.light.state());
    EXPECT_EQ(restored.steps(30, 40), walk.steps(30, 40));
    EXPECT_EQ(restored.room.light.state(), walk.room.light.state());
}

TEST(Restored, GoesOnWithTheSameBitsAfterAStepThatWasStopped) {
    Walk walk, restored;
    walk.steps(0, 6);
    const std::atomic<bool> stop{true};
    std::vector<ArrivingLight> arriving(walk.room.receivers.size());
    walk.room.light.step(walk.room.receivers, arriving, walk.room.budget, 2, &stop);
    EXPECT_EQ(checkIndirectState(walk.room.light.state()), std::nullopt);
    restored.room.light.restore(walk.room.light.state());
    EXPECT_EQ(restored.steps(6, 10), walk.steps(6, 10));
}

TEST(Restored, FromNothingIsNothing) {
    Walk walk, restored;
    const IndirectState nothing = walk.room.light.state();
    EXPECT_EQ(checkIndirectState(nothing), std::nullopt);
    restored.steps(0, 3);
    restored.room.light.restore(nothing);
    EXPECT_EQ(restored.steps(0, 5), walk.steps(0, 5));
}

class States : public testing::Test {
  protected:
    void SetUp() override {
        walk.steps(0, 4);
        state = walk.room.light.state();
        ASSERT_EQ(checkIndirectState(state), std::nullopt);
    }
    void expectRefusal(const IndirectState& bad, const char* words) {
        const std::optional<Sentence> said = checkIndirectState(bad);
        ASSERT_TRUE(said) << words;
        EXPECT_NE(said->english().find(words), std::string::npos) << said->english();
    }

    Walk walk;
    IndirectState state;
};

TEST_F(States, OfNumbersThatMakeNoSenseAreRefused) {
    const float none = std::numeric_limits<float>::quiet_NaN(),
                infinite = std::numeric_limits<float>::infinity();
    using Change = void (*)(IrradianceRecord&, RecordHistory&, float);
    constexpr std::array<Change, 16> kNumbers{
        [](IrradianceRecord& r, RecordHistory&, float x) { r.position.y = x; },
        [](IrradianceRecord& r, RecordHistory&, float x) { r.radius = x; },
        [](IrradianceRecord& r, RecordHistory&, float x) { r.normal.x = x; },
        [](IrradianceRecord& r, RecordHistory&, float x) {
            r.normal = {x, x, x};
        },
        [](IrradianceRecord& r, RecordHistory&, float x) { r.confidence = x; },
        [](IrradianceRecord& r, RecordHistory& h, float x) { h.irradiance.g = r.irradiance.g = x; },
        [](IrradianceRecord& r, RecordHistory&, float x) { r.slant.z = x; },
        [](IrradianceRecord& r, RecordHistory&, float x) { r.distance = x; },
        [](IrradianceRecord& r, RecordHistory& h, float x) {
            r.walls[0].offset = x;
            h.walls = NearestWalls::from(r.walls, {1, 1});
        },
        [](IrradianceRecord& r, RecordHistory& h, float x) {
            r.walls[1].normal.x = x;
            h.walls = NearestWalls::from(r.walls, {1, 1});
        },
        [](IrradianceRecord& r, RecordHistory& h, float x) {
            h.walls = NearestWalls::from(r.walls, {x, 1});
        },
        [](IrradianceRecord&, RecordHistory& h, float x) { h.vector.x = x; },
        [](IrradianceRecord&, RecordHistory& h, float x) { h.pixel = x; },
        [](IrradianceRecord&, RecordHistory& h, float x) { h.shrink = x; },
        [](IrradianceRecord&, RecordHistory& h, float x) { h.inverseLengths = x; },
        [](IrradianceRecord& r, RecordHistory&, float x) { r.radius = 2 * x; },
    };
    for (std::size_t i = 0; i < kNumbers.size(); ++i) {
        for (const float odd : {none, infinite, -infinite, 3e38F}) {
            IndirectState bad = state;
            kNumbers[i](bad.irradiance.records[5], bad.passes.histories[5], odd);
            EXPECT_NE(checkIndirectState(bad), std::nullopt) << i << ' ' << odd;
        }
    }
}

TEST_F(States, OfCountsThatMakeNoSenseAreRefused) {
    const auto refuse = [&](const char* words, auto&& change) {
        IndirectState bad = state;
        change(bad);
        expectRefusal(bad, words);
    };
    refuse("record 3", [](IndirectState& s) { s.passes.histories[3].density = kDensities; });
    refuse("record 3", [](IndirectState& s) { s.passes.histories[3].allPasses = s.frame + 1; });
    refuse("record 3",
           [](IndirectState& s) { s.passes.histories[3].passes = s.passes.histories[3].allPasses + 1; });
    refuse("record 3", [](IndirectState& s) { s.irradiance.lastUse[3] = s.frame + 2; });
    refuse("record 3", [](IndirectState& s) { s.irradiance.indexed[3] /= 2; });
    refuse("record 3", [](IndirectState& s) { s.irradiance.records[3].normal = {}; });
    refuse("record 3", [](IndirectState& s) { s.irradiance.records[3].radius = 0; });
    refuse("cell 9", [](IndirectState& s) { s.cells[9].count = 0; });
    refuse("cell 9", [](IndirectState& s) { s.cells[9].frame = s.frame + 1; });
    refuse("cell 9", [](IndirectState& s) { s.cells[9].squares = -1; });
    refuse("in order", [](IndirectState& s) { std::swap(s.cells[9], s.cells[10]); });
    refuse("numbers of records", [](IndirectState& s) { s.irradiance.indexed.pop_back(); });
    refuse("numbers of records", [](IndirectState& s) { s.passes.names = 5; });
    refuse("guess", [](IndirectState& s) { s.irradiance.guess.b = 1e30F; });
    refuse("guess", [](IndirectState& s) { s.frame = 0xFFFFFFFF; });
    refuse("too many", [](IndirectState& s) { s.cells.resize(IndirectState::kMaxCells + 1); });
}

TEST_F(States, OfRecordsThatLieInOneHeapAreRefused) {
    for (const float apart : {0.0F, 1e-7F}) {
        IndirectState bad = state;
        for (int i = 0; i < 5000; ++i) {
            bad.irradiance.records.push_back(bad.irradiance.records[0]);
            bad.irradiance.records.back().position.x += apart * static_cast<float>(i);
            bad.irradiance.indexed.push_back(bad.irradiance.indexed[0]);
            bad.irradiance.lastUse.push_back(0);
            bad.passes.histories.push_back(bad.passes.histories[0]);
        }
        bad.passes.names += 5000;
        expectRefusal(bad, "one place");
    }
}

} // namespace
} // namespace rtcore
