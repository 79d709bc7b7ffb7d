/// Servers of one name, servers of several names, other users.
#include "ipc/endpoint/client.h"
#include "process/ipc/troupe.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>

#include <fcntl.h>
#include <sys/resource.h>

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

// A desktop session and cron, a container with our shared memory: neither folders nor variables are a matter.
TEST(Isolation, SoItIsInAnyTwoEnvironments) {
    const TemporaryFolder a, b;
    for (int round = 0; round < rounds(20); ++round) {
        Troupe troupe;
        int index = 0;
        for (const TemporaryFolder* folder : {&a, &b}) {
            const std::string path = folder->path().string();
            const ChildSettings settings{.environment = {{"XDG_RUNTIME_DIR", path}, {"TMPDIR", path}}};
            troupe.put(index, troupe.participant(index, "server", {"patience=50"}, settings));
            ++index;
        }
        ASSERT_TRUE(eventually([&] { return troupe[0].wait(1ms) != -1 || troupe[1].wait(1ms) != -1; }));
        const int winner = troupe.board[0].progress > troupe.board[1].progress ? 0 : 1;
        EXPECT_TRUE(troupe.progresses({winner})) << "and the one is not disturbed";
        EXPECT_EQ(ipc::Client(troupe.instance.name()).serverProcess(), troupe[winner].process());
    }
}

// Neither notices the other at its start. Soon there is one again, and one scene for all clients.
TEST(Isolation, OfTwoServersAfterTheNamesWereRemovedOneStays) {
    for (int round = 0; round < rounds(2); ++round) {
        Troupe troupe;
        troupe.start(0, "server");
        troupe.start(2, "client");
        ASSERT_TRUE(troupe.progresses({0, 2}));
        for (const std::string& name : troupe.instance.segments()) ipc::Segment::remove(name);
        troupe.start(1, "server", {"patience=50"});
        int loser = -1, status = -1;
        ASSERT_TRUE(eventually(
            [&] {
                for (int i = 0; i < 2 && loser < 0; ++i) {
                    status = troupe[i].wait(1ms);
                    if (status != -1) loser = i;
                }
                return loser >= 0;
            },
            5s));
        EXPECT_EQ(WEXITSTATUS(status), 75);
        ASSERT_TRUE(troupe.progresses({1 - loser, 2}));
        EXPECT_EQ(ipc::Viewer(troupe.instance.name()).serverProcess(), troupe[1 - loser].process());
    }
}

TEST(Isolation, AnInstanceFeelsNothingOfAnothersDeath) {
    std::vector<std::unique_ptr<Troupe>> troupes;
    for (int i = 0; i < 8; ++i) {
        troupes.push_back(std::make_unique<Troupe>());
        troupes.back()->start(0, "server", {"pause=2000"});
        troupes.back()->start(1, "client", {"pause=2000"});
        ASSERT_TRUE(troupes.back()->progresses({0, 1}));
    }
    for (int round = 0; round < rounds(20); ++round) {
        const std::size_t victim = static_cast<std::size_t>(round) % troupes.size();
        (*troupes[victim])[0].kill();
        troupes[victim]->start(0, "server", {"pause=2000"});
        for (const auto& troupe : troupes) ASSERT_TRUE(troupe->progresses({0, 1}));
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

// The result of `attempt` in a process of another user.
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
    ASSERT_TRUE(troupe.progresses({0}));
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

// At a logout.
TEST(Isolation, RemovedFoldersAreNobodysMatter) {
    Troupe troupe;
    const TemporaryFolder session;
    const std::string path = (session / "run").string();
    std::filesystem::create_directory(path);
    const ChildSettings settings{.environment = {{"XDG_RUNTIME_DIR", path}, {"TMPDIR", path}}};
    for (const auto& [index, role] : {std::pair{0, "server"}, std::pair{1, "client"}})
        troupe.put(index, troupe.participant(index, role, {}, settings));
    ASSERT_TRUE(troupe.progresses({0, 1}));
    std::filesystem::remove_all(path);
    for (int i = 0; i < 3; ++i) {
        std::this_thread::sleep_for(500ms);
        ASSERT_TRUE(troupe.progresses({0, 1}));
    }
    EXPECT_EQ(troupe.board[1].epochs, 1U);
    EXPECT_TRUE(troupe.leavesNothing());
}

// Descriptors run out in the server, in a client, in both.
TEST(Isolation, WithoutDescriptorsForAWhileNobodyIsLost) {
    Troupe troupe;
    troupe.start(0, "server");
    troupe.start(1, "client");
    ASSERT_TRUE(troupe.progresses({0, 1}));
    const auto limit = [&](int index, rlim_t descriptors) {
        rlimit now{};
        ::prlimit(troupe[index].process(), RLIMIT_NOFILE, nullptr, &now);
        now.rlim_cur = descriptors;
        ::prlimit(troupe[index].process(), RLIMIT_NOFILE, &now, nullptr);
    };
    for (int round = 0; round < rounds(3); ++round) {
        for (int i = 0; i < 2; ++i) {
            if (round % 3 == 2 || round % 3 == i) limit(i, 3);
        }
        troupe[0].send(SIGSTOP); // so that the client looks whether it lives
        std::this_thread::sleep_for(150ms);
        troupe[0].send(SIGCONT);
        ASSERT_TRUE(troupe.progresses({0, 1})) << round;
        std::this_thread::sleep_for(1200ms); // the server's housekeeping
        for (int i = 0; i < 2; ++i) limit(i, 1024);
        ASSERT_TRUE(troupe.progresses({0, 1})) << round;
    }
    EXPECT_EQ(troupe.board[1].epochs, 1U);
    EXPECT_EQ(troupe.sum(&Counters::wrong), 0U);
    EXPECT_TRUE(troupe.leavesNothing());
}

TEST(Isolation, RemovedNamesComeBack) {
    Troupe troupe;
    troupe.start(0, "server");
    troupe.start(1, "client");
    ASSERT_TRUE(troupe.progresses({0, 1}));
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
