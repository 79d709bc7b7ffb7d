/// Servers of one name, servers of several names, other users.
#include "ipc/endpoint/client.h"
#include "process/ipc/troupe.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>

#include <fcntl.h>

namespace {

using namespace test;

TEST(Isolation, OfTwoServersStartedAtOnceOneWins) {
    for (int round = 0; round < rounds(50); ++round) {
        Troupe troupe;
        troupe.start(0, "server", {"patience=50"});
        troupe.start(1, "server", {"patience=50"});
        int loser = -1, status = -1;
        ASSERT_TRUE(eventually([&] {
            for (int i = 0; i < 2 && loser < 0; ++i) {
                status = troupe[i].wait(1ms);
                if (status != -1) loser = i;
            }
            return loser >= 0;
        }));
        ASSERT_TRUE(WIFEXITED(status));
        EXPECT_EQ(WEXITSTATUS(status), 75);
        EXPECT_EQ(troupe[1 - loser].wait(1ms), -1);
        ipc::Client client(troupe.instance.name());
        EXPECT_EQ(client.request("echo").text, "echo");
        EXPECT_EQ(client.serverProcess(), troupe[1 - loser].process());
    }
}

TEST(Isolation, AnInstanceFeelsNothingOfAnothersDeath) {
    std::vector<std::unique_ptr<Troupe>> troupes;
    for (int i = 0; i < 8; ++i) {
        troupes.push_back(std::make_unique<Troupe>());
        troupes.back()->start(0, "server", {"pause=2000"});
        troupes.back()->start(1, "client", {"pause=2000"});
        ASSERT_TRUE(troupes.back()->progresses({0, 1}, 3s));
    }
    for (int round = 0; round < rounds(20); ++round) {
        const std::size_t victim = static_cast<std::size_t>(round) % troupes.size();
        (*troupes[victim])[0].kill();
        troupes[victim]->start(0, "server", {"pause=2000"});
        for (const auto& troupe : troupes) ASSERT_TRUE(troupe->progresses({0, 1}, 1s));
    }
    for (std::size_t i = 0; i < troupes.size(); ++i) {
        const std::size_t deaths =
            static_cast<std::size_t>(rounds(20)) / 8 + (i < static_cast<std::size_t>(rounds(20)) % 8);
        EXPECT_EQ(troupes[i]->board[1].epochs, 1 + deaths);
        EXPECT_EQ(troupes[i]->sum(&Counters::wrong), 0u);
        EXPECT_TRUE(troupes[i]->leavesNothing());
    }
}

constexpr uid_t kNobody = 65534;

// What `attempt` returns in a process of another user.
int asAnotherUser(const std::function<int()>& attempt) {
    const pid_t child = ::fork();
    if (child == 0) {
        if (::setgid(kNobody) != 0 || ::setuid(kNobody) != 0) ::_exit(99);
        ::_exit(attempt());
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WEXITSTATUS(status);
}

TEST(Isolation, AnotherUserCanReadNothing) {
    if (::getuid() != 0) GTEST_SKIP() << "only root can be another user";
    Troupe troupe;
    troupe.start(0, "server");
    ASSERT_TRUE(troupe.progresses({0}, 3s));
    const auto names = troupe.instance.segments();
    ASSERT_EQ(names.size(), 2u);
    EXPECT_EQ(asAnotherUser([&] {
                  for (const std::string& name : names) {
                      const std::string path = "/dev/shm/" + name;
                      if (::open(path.c_str(), O_RDONLY) >= 0 || errno != EACCES) return 1;
                      if (::open(path.c_str(), O_RDWR) >= 0 || errno != EACCES) return 2;
                      if (::unlink(path.c_str()) == 0) return 3;
                  }
                  return 0;
              }),
              0);
    EXPECT_TRUE(troupe.progresses({0}));
}

TEST(Isolation, ANameTakenByAnotherUserIsRefused) {
    if (::getuid() != 0) GTEST_SKIP() << "only root can be another user";
    if (asAnotherUser([] { return ::access(RT_IPC_PARTICIPANT, X_OK); }) != 0) {
        GTEST_SKIP() << "another user cannot reach the programs of this build";
    }
    const Troupe troupe;
    const std::string name = "rts." + std::to_string(kNobody) + "." + troupe.instance.name() + ".ctl";
    std::ofstream("/dev/shm/" + name) << std::string(4 << 20, 'x');
    std::filesystem::permissions("/dev/shm/" + name, std::filesystem::perms(0666));
    const TemporaryFolder theirs;
    ASSERT_EQ(::chown(theirs.path().c_str(), kNobody, kNobody), 0);
    ::setenv("XDG_RUNTIME_DIR", theirs.path().c_str(), 1);
    const std::string board = theirs / "board";
    for (const char* role : {"server", "client", "viewer"}) {
        const auto start = Clock::now();
        EXPECT_EQ(asAnotherUser([&] {
                      ::close(2);
                      ::execl(RT_IPC_PARTICIPANT, RT_IPC_PARTICIPANT, role, troupe.instance.name().c_str(),
                              board.c_str(), "0", "once=1", nullptr);
                      return 98;
                  }),
                  77)
            << role;
        EXPECT_LT(Clock::now() - start, 3s);
    }
    std::filesystem::remove("/dev/shm/" + name);
}

TEST(Isolation, RemovedNamesComeBack) {
    Troupe troupe;
    troupe.start(0, "server");
    troupe.start(1, "client");
    ASSERT_TRUE(troupe.progresses({0, 1}, 3s));
    for (int round = 1; round <= rounds(3); ++round) {
        for (const std::string& name : troupe.instance.segments()) ipc::Segment::remove(name);
        ASSERT_TRUE(
            eventually([&] { return troupe.board[1].epochs == static_cast<unsigned>(round) + 1; }, 3s));
        ASSERT_TRUE(troupe.progresses({0, 1}));
        EXPECT_NO_THROW(ipc::Viewer(troupe.instance.name()));
    }
    EXPECT_TRUE(troupe.leavesNothing());
}

} // namespace
