/// Death at each named point of the protocol, in the server and in a client.
#include "ipc/endpoint/client.h"
#include "process/ipc/troupe.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace test;

struct Point {
    const char* role;
    const char* point;
    bool beforeRunning = false; ///< the server is not to be found when it dies there
    bool once = false;          ///< it comes there once in its life
};

class DeathAt : public testing::TestWithParam<Point> {
  protected:
    bool server() const { return std::string(GetParam().role) == "server"; }

    // Gives the victim occasion: sizes change with every frame, a client comes and goes or is killed.
    bool comesToThePoint(int time) {
        const bool again = server() && !GetParam().beforeRunning && !GetParam().once;
        const std::string dieAt = std::string(GetParam().point) + ":" + std::to_string(again ? time : 1);
        const std::uint64_t before = troupe.board[1].progress;
        troupe.start(0, "server", kServer, server() ? dieAt : "");
        troupe.start(1, "client", {}, server() ? "" : dieAt);
        troupe.start(2, "client");
        ChildProcess& victim = troupe[server() ? 0 : 1];
        for (int i = 0; i < 100; ++i) {
            const int status = victim.wait(30ms);
            if (status != -1) return WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;
            if (server()) troupe.start(1, "client");
            if (!server() && troupe.board[1].progress > before) victim.send(SIGTERM);
        }
        return false;
    }
    void expectNoServer() {
        const auto start = Clock::now();
        try {
            const ipc::Viewer viewer(troupe.instance.name(), 50ms);
            ADD_FAILURE() << "found a server that was never complete";
        } catch (const ipc::Error& error) {
            EXPECT_EQ(error.problem, ipc::Problem::NoServer) << error.what();
        }
        EXPECT_LT(Clock::now() - start, 1s);
    }

    const std::vector<std::string> kServer = {"resize=1"};
    Troupe troupe;
};

TEST_P(DeathAt, IsSurvived) {
    for (int time = 1; time <= rounds(2); ++time) {
        ASSERT_TRUE(comesToThePoint(time));
        if (GetParam().beforeRunning) expectNoServer();
        if (server()) troupe.start(0, "server", kServer);
        troupe.start(1, "client");
        ASSERT_TRUE(troupe.progresses(troupe.all()));
        EXPECT_EQ(troupe.sum(&Counters::torn), 0u);
        EXPECT_EQ(troupe.sum(&Counters::wrong), 0u);
        EXPECT_TRUE(troupe.leavesNothing());
    }
}

template <class Endpoint>
bool findsNoServer(const std::string& instance) {
    try {
        const Endpoint endpoint(instance, 30ms);
    } catch (const ipc::Error& error) {
        return error.problem == ipc::Problem::NoServer;
    }
    return false;
}

// Alive, and with its lock, but not complete: nobody may attach. It may be as slow as it likes.
TEST(StoppedAt, AnyPointOfTheStartIsNoServerYet) {
    for (const char* point :
         {"segment unlocked", "server locked", "names cleared", "segment made", "segment reserved",
          "control made", "header written", "frames laid out", "before magic"}) {
        Troupe troupe;
        troupe.start(0, "server", {}, std::string(point) + ":1:stop");
        int status = 0;
        ASSERT_EQ(::waitpid(troupe[0].process(), &status, WUNTRACED), troupe[0].process());
        ASSERT_TRUE(WIFSTOPPED(status)) << point;
        EXPECT_TRUE(findsNoServer<ipc::Viewer>(troupe.instance.name())) << point;
        EXPECT_TRUE(findsNoServer<ipc::Client>(troupe.instance.name())) << point;
        troupe[0].send(SIGCONT);
        EXPECT_EQ(ipc::Client(troupe.instance.name()).request("echo").status, ipc::ReplyStatus::Done)
            << point;
    }
}

constexpr Point kPoints[] = {
    {"server", "server locked", true},
    {"server", "names cleared", true},
    {"server", "segment unlocked", true},
    {"server", "segment made", true},
    {"server", "segment reserved", true},
    {"server", "control made", true},
    {"server", "header written", true},
    {"server", "frames laid out", true},
    {"server", "before magic", true},
    {"server", "after magic", false, true},
    {"server", "frame drawn"},
    {"server", "frame whole"},
    {"server", "frames replaced"},
    {"server", "queue opened"},
    {"server", "client adopted"},
    {"server", "client found dead"},
    {"server", "command taken"},
    {"server", "before answer"},
    {"server", "reply written"},
    {"client", "queue made"},
    {"client", "slot filled"},
    {"client", "slot claimed"},
    {"client", "command sent"},
    {"client", "slot left"},
};

INSTANTIATE_TEST_SUITE_P(Points, DeathAt, testing::ValuesIn(kPoints), [](const auto& point) {
    std::string name = std::string(point.param.role) + "_" + point.param.point;
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
});

} // namespace
