/// kill -9 of RTServer, of CUI and of other clients at random moments: everybody gets on, no frame is torn,
/// nothing is left.
#include "process/server/besieged_server.h"

#include <algorithm>
#include <random>

namespace {

using namespace test;

class KilledServer : public Besieged {
  protected:
    // Names in shared memory that belong to no living program. Queues are their owners' affair: the server
    // looks each second.
    std::vector<std::string> stale() {
        std::vector<std::string> names;
        const std::string frames = troupe.instance.names().prefix() + "f";
        const std::string own = troupe.instance.names().frames(viewer->epoch(), 0);
        const std::string ownPrefix = own.substr(0, own.size() - 1);
        for (const std::string& name : troupe.instance.segments()) {
            if (name.starts_with(frames) && !name.starts_with(ownPrefix)) names.push_back(name);
        }
        return names;
    }
    static double milliseconds(Clock::duration time) {
        return std::chrono::duration<double, std::milli>(time).count();
    }
    static double quantile(std::vector<double>& values, double q) {
        if (values.empty()) return 0;
        std::sort(values.begin(), values.end());
        return values.at(static_cast<std::size_t>(q * static_cast<double>(values.size() - 1)));
    }
};

TEST_F(KilledServer, AtRandomWithItsClients) {
    constexpr const char* kRoles[] = {"", "talker", "talker", "talker", "viewer", "shell", "shell"};
    const int kills = rounds(50);
    std::mt19937 random(20100601);
    ASSERT_TRUE(stands());
    for (int i = 1; i <= 6; ++i) troupe.start(i, kRoles[i]);
    ASSERT_TRUE(troupe.progresses(visitors(), 10s));
    std::vector<double> starts, recoveries;
    for (int i = 0; i < kills; ++i) {
        std::this_thread::sleep_for(std::chrono::microseconds(random() % 20000));
        const int victim = random() % 4 == 0 ? 0 : 1 + static_cast<int>(random() % 6);
        const auto death = Clock::now();
        troupe[victim].kill();
        if (victim == 0) {
            ASSERT_TRUE(stands()) << "kill " << i;
            starts.push_back(milliseconds(Clock::now() - death));
            EXPECT_EQ(stale(), std::vector<std::string>()) << "kill " << i;
        } else {
            troupe.start(victim, kRoles[victim]);
        }
        const auto standing = Clock::now();
        ASSERT_TRUE(troupe.progresses(visitors(), 1s)) << "kill " << i << " of " << kRoles[victim];
        recoveries.push_back(milliseconds(Clock::now() - standing));
    }
    std::printf("%d kills, %zu of them of the server, which stands again after %.0f ms median, %.0f max; "
                "then everybody gets on within %.1f ms median, %.1f p99, %.1f max; %llu frames seen\n",
                kills, starts.size(), quantile(starts, 0.5), quantile(starts, 1), quantile(recoveries, 0.5),
                quantile(recoveries, 0.99), quantile(recoveries, 1),
                static_cast<unsigned long long>(troupe.sum(&Counters::frames)));
    expectNothingWrong();
    EXPECT_GT(troupe.board[4].epochs, 5U);
    // All die at once, and all their names are left; the next server removes them.
    for (int i = troupe.size() - 1; i >= 0; --i) troupe[i].kill();
    EXPECT_FALSE(troupe.instance.segments().empty());
    ASSERT_TRUE(stands());
    EXPECT_EQ(troupe.instance.segments().size(), 2U) << "the control segment and the frames";
    expectGoodEnd();
}

// Wherever it is in its start, the next one stands.
TEST_F(KilledServer, WhileItStarts) {
    const char* asked = std::getenv("RT_START_KILLS");
    const int kills = asked == nullptr ? 20 : std::max(1, std::atoi(asked));
    std::mt19937 random(20101121);
    std::vector<double> starts;
    for (int i = 0; i < kills; ++i) {
        troupe.put(0, newServer());
        std::this_thread::sleep_for(std::chrono::microseconds(random() % 150000));
        troupe[0].kill();
        const auto start = Clock::now();
        ASSERT_TRUE(stands()) << "kill " << i;
        starts.push_back(milliseconds(Clock::now() - start));
        EXPECT_EQ(troupe.instance.segments().size(), 2U) << "kill " << i;
        EXPECT_EQ(ipc::Client(troupe.instance.name()).request("ping", 5s).text, "pong") << "kill " << i;
        troupe[0].kill();
    }
    std::printf("%d starts after a kill: %.0f ms median, %.0f p99, %.0f max\n", kills, quantile(starts, 0.5),
                quantile(starts, 0.99), quantile(starts, 1));
    ASSERT_TRUE(stands());
    expectGoodEnd();
}

TEST_F(KilledServer, OfTwoStartedAtOnceOneWins) {
    for (int round = 0; round < rounds(1); ++round) {
        ChildProcess rivals[] = {newServer(), newServer()};
        int loser = -1, status = -1;
        ASSERT_TRUE(eventually(
            [&] {
                for (int i = 0; i < 2 && loser < 0; ++i) {
                    status = rivals[i].wait(1ms);
                    if (status != -1) loser = i;
                }
                return loser >= 0;
            },
            10s));
        ASSERT_TRUE(WIFEXITED(status));
        EXPECT_EQ(WEXITSTATUS(status), 75);
        ipc::Client client(troupe.instance.name());
        EXPECT_EQ(client.request("ping", 5s).text, "pong");
        EXPECT_EQ(client.serverProcess(), rivals[1 - loser].process());
        EXPECT_EQ(troupe.instance.segments().size(), 2U);
    }
}

} // namespace
