/// Frames at any speed and size, looked at by several viewers: each is whole.
#include "process/ipc/troupe.h"

#include <gtest/gtest.h>

namespace {

using namespace test;

struct Speed {
    const char* name;
    int side, pause, resize, frames;
};

class Frames : public testing::TestWithParam<Speed> {};

TEST_P(Frames, AreWhole) {
    const Speed speed = GetParam();
    Troupe troupe;
    troupe.start(0, "server",
                 {"side=" + std::to_string(speed.side), "pause=" + std::to_string(speed.pause),
                  "resize=" + std::to_string(speed.resize)});
    for (int i = 1; i <= 3; ++i) troupe.start(i, "viewer");
    const auto seen = [&] {
        return troupe.board[1].frames + troupe.board[2].frames + troupe.board[3].frames;
    };
    ASSERT_TRUE(eventually([&] { return seen() >= static_cast<std::uint64_t>(rounds(speed.frames)); },
                           rounds(1) * std::chrono::seconds(60)))
        << seen() << " frames seen, " << troupe.board[0].progress << " published";
    EXPECT_EQ(troupe.sum(&Counters::torn), 0u) << "of " << seen();
    for (int i = 1; i <= 3; ++i) EXPECT_EQ(troupe.board[i].epochs, 1u);
    EXPECT_TRUE(troupe.leavesNothing());
}

INSTANTIATE_TEST_SUITE_P(Speeds, Frames,
                         testing::Values(Speed{"SmallFlatOut", 64, 0, 0, 20000},
                                         Speed{"SmallResized", 64, 0, 50, 5000},
                                         Speed{"SmallWithPauses", 64, 500, 50, 2000},
                                         Speed{"LargeFlatOut", 1400, 0, 0, 300},
                                         Speed{"LargeResized", 900, 1000, 50, 300}),
                         [](const auto& speed) { return std::string(speed.param.name); });

} // namespace
