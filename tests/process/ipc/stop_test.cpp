/// Stopped processes: alive, but silent.
#include "ipc/endpoint/client.h"
#include "process/ipc/troupe.h"

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace test;

TEST(Stopped, AServerIsBusyNeverDead) {
    Troupe troupe;
    troupe.start(0, "server");
    troupe.start(1, "client");
    ipc::Client client(troupe.instance.name());
    const std::uint64_t epoch = client.epoch();
    ASSERT_TRUE(troupe.progresses({0, 1}, 3s));
    std::mt19937 random(5);
    for (int round = 0; round < rounds(5); ++round) {
        troupe[0].send(SIGSTOP);
        EXPECT_TRUE(eventually([&] { return client.update() == ipc::LinkState::Busy; }));
        // A full queue is told at once.
        ipc::SendStatus status = ipc::SendStatus::Sent;
        for (int i = 0; i < 40; ++i) status = client.send("x");
        EXPECT_EQ(status, ipc::SendStatus::Full);
        const auto start = Clock::now();
        for (int i = 0; i < 100; ++i) client.send("x");
        EXPECT_LT(Clock::now() - start, 100ms);
        const auto end = Clock::now() + std::chrono::milliseconds(100 + random() % 300);
        while (Clock::now() < end) {
            ASSERT_EQ(client.update(), ipc::LinkState::Busy);
            std::this_thread::sleep_for(1ms);
        }
        troupe[0].send(SIGCONT);
        ASSERT_TRUE(troupe.progresses({0, 1}));
        EXPECT_TRUE(eventually([&] { return client.request("echo").status == ipc::ReplyStatus::Done; }));
    }
    EXPECT_EQ(client.epoch(), epoch);
    EXPECT_EQ(troupe.board[1].epochs, 1u);
}

// Its lock stands for a segment that nobody finds any more: the epoch tells its clients. It yields when it
// wakes.
TEST(Stopped, AServerWhoseNameWasTakenIsLeft) {
    Troupe troupe;
    troupe.start(0, "server");
    troupe.start(2, "client");
    ASSERT_TRUE(troupe.progresses({0, 2}, 3s));
    troupe[0].send(SIGSTOP);
    for (const std::string& name : troupe.instance.segments()) ipc::Segment::remove(name);
    troupe.start(1, "server");
    ASSERT_TRUE(troupe.progresses({1, 2}, 3s));
    // At first the client may still get on with what the old segment holds.
    EXPECT_TRUE(eventually([&] { return troupe.board[2].epochs == 2U; }, 3s));
    troupe[0].send(SIGCONT);
    EXPECT_EQ(WEXITSTATUS(troupe[0].wait(3s)), 75);
    ASSERT_TRUE(troupe.progresses({1, 2}));
}

TEST(Stopped, AClientHoldsNobodyUpAndComesBack) {
    Troupe troupe;
    troupe.start(0, "server");
    troupe.start(1, "client", {"pause=0"});
    troupe.start(2, "client");
    ASSERT_TRUE(troupe.progresses(troupe.all(), 3s));
    std::mt19937 random(6);
    for (int round = 0; round < rounds(20); ++round) {
        troupe[1].send(SIGSTOP);
        for (int i = 0; i < 5; ++i) ASSERT_TRUE(troupe.progresses({0, 2}, 500ms));
        std::this_thread::sleep_for(std::chrono::microseconds(random() % 20000));
        troupe[1].send(SIGCONT);
        ASSERT_TRUE(troupe.progresses(troupe.all(), 1500ms)); // its request may have timed out meanwhile
    }
    EXPECT_EQ(troupe.sum(&Counters::wrong), 0u);
    EXPECT_TRUE(troupe.leavesNothing());
}

} // namespace
