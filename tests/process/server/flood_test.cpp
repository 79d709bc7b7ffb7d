/// Clients that flood, that send what is no command, and that stop: the others do not notice.
#include "process/server/besieged_server.h"

#include <algorithm>
#include <optional>

namespace {

using namespace test;

class Flooded : public Besieged {
  protected:
    static constexpr double kRate = 50; ///< frames per second
    const std::vector<std::string> kLimited = {"--fps-limit=50"};

    // Draws all the time, and answers everybody else at once. The time that processes take by running at all
    // is no matter of the server.
    void begin(int spinners = 0) {
        ASSERT_TRUE(stands(kLimited));
        client.emplace(troupe.instance.name());
        ASSERT_EQ(client->request("idle off").status, ipc::ReplyStatus::Done);
        for (int i = 1; i <= spinners; ++i) troupe.start(i, "spinner");
        usual = rate();
    }
    double rate() {
        const auto start = Clock::now();
        const auto drawn = static_cast<double>(frames(1s));
        return drawn / std::chrono::duration<double>(Clock::now() - start).count();
    }
    void expectUnhurt() {
        std::vector<double> waits;
        double drawn = 0;
        for (int round = 0; round < rounds(1) || (!kSanitized && round < 5 && drawn < 0.9 * usual); ++round) {
            drawn = std::max(drawn, rate());
            for (int i = 0; i < 20; ++i) {
                const auto start = Clock::now();
                const ipc::Reply reply = client->request("ping", 2s);
                ASSERT_EQ(reply.status, ipc::ReplyStatus::Done) << reply.text;
                waits.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
            }
            EXPECT_EQ(cui({"ping"}).output, "pong\n");
        }
        std::sort(waits.begin(), waits.end());
        std::printf("%.1f frames per second, %.1f without; answers after %.2f ms median, %.1f max\n", drawn,
                    usual, waits[waits.size() / 2], waits.back());
        EXPECT_GT(drawn, 0.2 * kRate);
        if (kSanitized) return;
        EXPECT_GE(drawn, 0.5 * usual); // other programs run beside it
        EXPECT_LT(waits[waits.size() / 2], 50);
    }
    std::size_t residentBytes() {
        std::ifstream file("/proc/" + std::to_string(troupe[0].process()) + "/statm");
        std::size_t all = 0, resident = 0;
        file >> all >> resident;
        return resident * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
    }

    std::optional<ipc::Client> client;
    double usual = 0;
};

TEST_F(Flooded, ByMessagesThatAreNone) {
    begin(2);
    troupe.start(1, "junk");
    troupe.start(2, "junk");
    ASSERT_TRUE(troupe.progresses({1, 2}));
    expectUnhurt();
    expectNothingWrong();
    expectGoodEnd();
}

TEST_F(Flooded, ByCommandsThatAreNone) {
    begin(2);
    troupe.start(1, "nonsense");
    troupe.start(2, "nonsense");
    ASSERT_TRUE(troupe.progresses({1, 2}));
    expectUnhurt();
    EXPECT_LT(log().size(), 100'000U * static_cast<unsigned>(rounds(1))) << "the log is not flooded";
    expectNothingWrong();
    expectGoodEnd();
}

// Each of them can be taken from the queue, but not yet done.
TEST_F(Flooded, ByCommandsThatMustWait) {
    begin();
    troupe.start(1, "waiter");
    ASSERT_TRUE(troupe.progresses({1}));
    std::this_thread::sleep_for(500ms);
    const std::size_t before = residentBytes();
    for (int i = 0; i < 20 * rounds(1); ++i) {
        ASSERT_EQ(client->request("ping", 5s).status, ipc::ReplyStatus::Done);
        std::this_thread::sleep_for(50ms);
    }
    if (!kSanitized) {
        EXPECT_LT(residentBytes(), before + 8'000'000);
    }
    expectGoodEnd();
}

TEST_F(Flooded, ByClientsThatStopInTheMiddle) {
    begin();
    for (int i = 1; i <= 4; ++i) troupe.start(i, i <= 2 ? "talker" : "nonsense");
    ASSERT_TRUE(troupe.progresses(visitors(), 3s));
    for (int i = 1; i <= 4; ++i) troupe[i].send(SIGSTOP);
    expectUnhurt();
    for (int i = 1; i <= 4; ++i) troupe[i].send(SIGCONT);
    EXPECT_TRUE(troupe.progresses(visitors(), 2s));
    expectNothingWrong();
    expectGoodEnd();
}

// Whoever started the server does not read what it prints.
TEST_F(Flooded, WhileNobodyReadsItsErrors) {
    RunningProgram server(programPath("RTServer"),
                          {(folder() / "grey.scn").string(), "--instance=" + troupe.instance.name(),
                           "--resolution=64x48", "--threads=1"});
    ASSERT_TRUE(server.waitForError("ready: "));
    ipc::Client sender(troupe.instance.name());
    for (int i = 0; i < 200; ++i) {
        while (sender.send(std::string(4000, 'x')) == ipc::SendStatus::Full) std::this_thread::sleep_for(1ms);
        if (i % 20 == 19) {
            ASSERT_EQ(sender.request("ping", 2s).status, ipc::ReplyStatus::Done) << i;
        }
    }
    server.send(SIGTERM);
    EXPECT_EQ(server.wait().exitCode, 143);
}

} // namespace
