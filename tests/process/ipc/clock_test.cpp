/// The wall clock is set by an hour, to and fro, while server and clients wait: no wait is longer than it was
/// asked for.
#include "process/ipc/troupe.h"

#include <gtest/gtest.h>

namespace {

using namespace test;

TEST(ClockThatIsSet, HoldsNobodyUp) {
    if (kSanitized) GTEST_SKIP() << "a sanitizer must be the first library of a program";
    Troupe troupe;
    const ChildSettings unsteady{.environment = {{"LD_PRELOAD", RT_UNSTEADY_CLOCK}}};
    const auto start = [&](int index, const std::string& role, const std::vector<std::string>& options = {}) {
        troupe.put(index, troupe.participant(index, role, options, unsteady));
    };
    start(0, "server", {"pause=20000"});
    start(1, "client");
    start(2, "client");
    start(3, "viewer");
    ASSERT_TRUE(troupe.progresses(troupe.all(), 3s));
    for (int round = 0; round < rounds(20); ++round) ASSERT_TRUE(troupe.progresses(troupe.all(), 500ms));
    // A server that sleeps wakes, and a death is noticed.
    for (int round = 0; round < rounds(2); ++round) {
        const std::uint64_t before = troupe.board[1].epochs;
        troupe[0].kill();
        start(0, "server", {"pause=500000"});
        ASSERT_TRUE(eventually([&] { return troupe.board[1].epochs > before; }, 1s));
        for (int i = 0; i < 10; ++i) ASSERT_TRUE(troupe.progresses({1, 2}, 200ms));
    }
    // The server of a short request is stopped: the client gives up in time.
    const std::uint64_t before = troupe.board[1].timeouts;
    troupe[0].send(SIGSTOP);
    ASSERT_TRUE(eventually([&] { return troupe.board[1].timeouts > before; }, 2s));
    troupe[0].send(SIGCONT);
    ASSERT_TRUE(troupe.progresses({1, 2}, 2s));
    EXPECT_EQ(troupe.sum(&Counters::wrong), 0u);
    EXPECT_TRUE(troupe.leavesNothing());
}

// Boost bounds how long it tries to get a queue's mutex, which a stopped client may have, by the wall clock.
TEST(ClockThatIsSet, DoesNotStretchTheWaitForAQueue) {
    if (kSanitized) GTEST_SKIP() << "a sanitizer must be the first library of a program";
    for (int round = 0; round < rounds(3); ++round) {
        ChildProcess test(RT_IPC_UNIT_TESTS,
                          {"--gtest_filter=Queues.OneWhoseMutexIsKept*", "--gtest_brief=1"},
                          {.environment = {{"LD_PRELOAD", RT_UNSTEADY_CLOCK}}});
        EXPECT_EQ(test.wait(10s), 0);
    }
}

} // namespace
