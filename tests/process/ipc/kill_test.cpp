/// kill -9 at random moments (docs/protocol.md, "Deaths"): everybody gets on, nothing is torn, nothing is
/// left.
#include "ipc/endpoint/client.h"
#include "ipc/endpoint/link.h"
#include "process/ipc/troupe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace {

using namespace test;

struct Recovery {
    std::vector<double> milliseconds;
    double quantile(double q) {
        std::sort(milliseconds.begin(), milliseconds.end());
        return milliseconds.at(static_cast<std::size_t>(q * static_cast<double>(milliseconds.size() - 1)));
    }
};

// Queues in which a client died, and which the server threw away. To be asked after each kill.
class PoisonedQueues {
  public:
    explicit PoisonedQueues(const Troupe& troupe) : names_(troupe.instance.names()) {}
    void look() {
        const std::optional<ipc::Link> link = ipc::Link::open(names_, ipc::Access::Read);
        if (!link) return;
        for (const ipc::ClientSlot& slot : link->block().clients) {
            if (slot.dropReason == ipc::DropReason::BrokenQueue) tags_.insert(slot.droppedTag);
        }
    }
    std::size_t count() const { return tags_.size(); }

  private:
    ipc::Names names_;
    std::set<std::uint64_t> tags_;
};

// A quarter of the kills hit the server.
void killAtRandom(Troupe& troupe, int kills, const std::string& clientRole,
                  const std::vector<std::string>& server, PoisonedQueues& poisoned) {
    std::mt19937 random(20100601);
    troupe.start(0, "server", server);
    for (int i = 1; i <= 4; ++i) troupe.start(i, i == 4 ? "client" : clientRole);
    troupe.start(5, "viewer");
    ASSERT_TRUE(troupe.progresses(troupe.all(), 5s));
    Recovery recovery;
    for (int i = 0; i < kills; ++i) {
        std::this_thread::sleep_for(std::chrono::microseconds(random() % 10000));
        const int victim = random() % 4 == 0 ? 0 : 1 + static_cast<int>(random() % 4);
        troupe[victim].kill();
        troupe.start(victim, victim == 0 ? "server" : victim == 4 ? "client" : clientRole, server);
        const auto start = Clock::now();
        ASSERT_TRUE(troupe.progresses(troupe.all()))
            << "kill " << i << " of " << (victim == 0 ? "server" : "client");
        recovery.milliseconds.push_back(
            std::chrono::duration<double, std::milli>(Clock::now() - start).count());
        poisoned.look();
    }
    std::printf(
        "%d kills, %llu frames seen, recovery %.1f ms median, %.1f p99, %.1f max; %zu poisoned queues\n",
        kills, static_cast<unsigned long long>(troupe.sum(&Counters::frames)), recovery.quantile(0.5),
        recovery.quantile(0.99), recovery.quantile(1), poisoned.count());
    EXPECT_EQ(troupe.sum(&Counters::torn), 0u);
    EXPECT_EQ(troupe.sum(&Counters::wrong), 0u);
    EXPECT_GT(troupe.board[4].epochs, 10u);
    // A last death of the server, so that its names are left; the next one removes them.
    troupe[0].kill();
    troupe.start(0, "server", server);
    ASSERT_TRUE(troupe.progresses(troupe.all()));
    EXPECT_TRUE(troupe.leavesNothing());
}

TEST(Killed, ServersAndClients) {
    Troupe troupe;
    PoisonedQueues poisoned(troupe);
    killAtRandom(troupe, rounds(400), "client", {}, poisoned);
}

// Finds deaths inside the queue, where Boost's mutex is.
TEST(Killed, ClientsInTheMiddleOfSending) {
    Troupe troupe;
    PoisonedQueues poisoned(troupe);
    const int kills = rounds(200);
    killAtRandom(troupe, kills, "flood", {"pause=0"}, poisoned);
    // One kill in a hundred: fewer kills may miss.
    if (kills >= 1000) {
        EXPECT_GT(poisoned.count(), 0u) << "nobody died where it hurts";
    }
}

TEST(Killed, AServerIsNoticedAndItsLastFrameStays) {
    Troupe troupe;
    troupe.start(0, "server");
    ipc::Client client(troupe.instance.name());
    ipc::Viewer viewer(troupe.instance.name());
    ASSERT_TRUE(troupe.progresses({0})) << "it has published frames";
    ASSERT_EQ(client.request("echo").status, ipc::ReplyStatus::Done);
    ipc::Ticket ticket = 0;
    troupe[0].send(SIGSTOP);
    EXPECT_EQ(client.send("echo", &ticket), ipc::SendStatus::Sent);
    troupe[0].kill();
    EXPECT_EQ(client.wait(ticket, kLongest).status, ipc::ReplyStatus::Lost);
    EXPECT_TRUE(eventually([&] { return viewer.update() == ipc::LinkState::Gone; }, kLongest));
    ipc::Frame frame;
    EXPECT_TRUE(viewer.readFrame(frame));
    EXPECT_EQ(client.send("echo"), ipc::SendStatus::NoServer);
    EXPECT_EQ(client.request("echo", 20ms).status, ipc::ReplyStatus::NotSent);
}

// The lock is never seen free: the epoch alone tells.
TEST(Killed, AServerThatIsReplacedUnseenIsNoticed) {
    Troupe troupe;
    troupe.start(0, "server");
    ipc::Client client(troupe.instance.name());
    ipc::Viewer viewer(troupe.instance.name());
    ipc::Frame frame;
    ASSERT_TRUE(viewer.waitForFrame(frame, kLongest));
    ASSERT_EQ(client.request("echo").status, ipc::ReplyStatus::Done);
    troupe[0].kill();
    troupe.start(0, "server");
    ASSERT_TRUE(troupe.progresses({0}, 3s));
    EXPECT_TRUE(eventually([&] { return client.request("echo", 200ms).status == ipc::ReplyStatus::Done; }));
    EXPECT_EQ(client.serverProcess(), troupe[0].process());
    const std::uint64_t before = frame.epoch;
    EXPECT_TRUE(eventually([&] { return viewer.readFrame(frame) && frame.epoch != before; }));
}

TEST(Killed, WhileWaitingForABusyServer) {
    Troupe troupe;
    troupe.start(0, "server", {"idle=1"});
    for (int i = 1; i <= 4; ++i) troupe.start(i, "client", {"pause=0"});
    troupe.start(5, "flood");
    ASSERT_TRUE(troupe.progresses(troupe.all(), 5s));
    std::mt19937 random(3);
    for (int round = 0; round < rounds(30); ++round) {
        troupe[0].send(SIGSTOP);
        std::this_thread::sleep_for(std::chrono::microseconds(2000 + random() % 5000));
        const int dead[] = {1 + static_cast<int>(random() % 2), 3 + static_cast<int>(random() % 3)};
        for (const int victim : dead) troupe[victim].kill();
        troupe[0].send(SIGCONT);
        for (const int victim : dead) troupe.start(victim, victim == 5 ? "flood" : "client", {"pause=0"});
        ASSERT_TRUE(troupe.progresses(troupe.all())) << "round " << round;
    }
    EXPECT_EQ(troupe.sum(&Counters::wrong), 0u);
    for (int i = 1; i <= 5; ++i) EXPECT_LE(troupe.board[i].epochs, 1u + static_cast<unsigned>(rounds(30)));
    EXPECT_TRUE(troupe.leavesNothing());
}

} // namespace
