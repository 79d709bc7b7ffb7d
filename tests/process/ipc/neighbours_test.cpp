/// Other users of this machine, who may put whatever they like at names that a program of ours opens: nobody
/// waits for them, and they are told from servers.
#include "ipc/endpoint/client.h"
#include "ipc/endpoint/server.h"
#include "process/ipc/troupe.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>

namespace {

using namespace test;

constexpr uid_t kNobody = 65534;

// The exit code of `work` in a process of user nobody; 128 and more when it had to be ended.
int asNobody(const std::function<int()>& work) {
    const pid_t child = ::fork();
    if (child == 0) {
        if (::setgid(kNobody) != 0 || ::setuid(kNobody) != 0) ::_exit(99);
        ::alarm(5);
        ::_exit(work());
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

int problemOf(const std::function<void()>& act) {
    try {
        act();
    } catch (const ipc::Error& error) {
        return static_cast<int>(error.problem);
    }
    return 90;
}

// The squatter is root, the victim nobody: root is who can be both.
class Squatted : public testing::Test {
  protected:
    void SetUp() override {
        if (::getuid() != 0) GTEST_SKIP() << "only root can be another user";
    }
    ~Squatted() override { std::filesystem::remove_all(path); }

    void expectRefused() {
        const std::string name = instance.name();
        const int notYours = static_cast<int>(ipc::Problem::NotYours);
        const std::vector<std::pair<const char*, std::function<void()>>> attempts = {
            {"server", [&] { const ipc::Server server({.instance = name, .width = 8, .height = 8}); }},
            {"viewer", [&] { const ipc::Viewer viewer(name, 100ms); }},
            {"client", [&] { const ipc::Client client(name, 100ms); }}};
        for (const auto& [who, attempt] : attempts)
            EXPECT_EQ(asNobody([&] { return problemOf(attempt); }), notYours) << who;
        EXPECT_EQ(asNobody([&] {
                      for (const ipc::Instance& each : ipc::listInstances()) {
                          if (each.name == name) return 1;
                      }
                      if (ipc::isAvailable(name)) return 2;
                      return ipc::freeInstance(name) == 0 ? 0 : 3;
                  }),
                  0)
            << "it is not in the list, not to be had, and nothing of it is ours to remove";
        EXPECT_TRUE(std::filesystem::exists(std::filesystem::symlink_status(path)));
    }

    const IpcInstance instance;
    const std::string path = "/dev/shm/rts." + std::to_string(kNobody) + "." + instance.name() + ".ctl";
};

TEST_F(Squatted, ByAPipe) {
    ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
    ASSERT_EQ(::chmod(path.c_str(), 0666), 0);
    expectRefused();
}

TEST_F(Squatted, ByAFile) {
    std::ofstream(path) << std::string(4 << 20, 'x');
    std::filesystem::permissions(path, std::filesystem::perms(0666));
    expectRefused();
}

TEST_F(Squatted, ByALink) {
    std::filesystem::create_symlink("/dev/zero", path);
    expectRefused();
}

TEST_F(Squatted, ByAFolder) {
    std::filesystem::create_directory(path);
    expectRefused();
}

TEST_F(Squatted, ByASocket) {
    const int socket = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path.copy(address.sun_path, sizeof address.sun_path - 1);
    ASSERT_EQ(::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    ::chmod(path.c_str(), 0666);
    expectRefused();
    ::close(socket);
}

// A server whose names were removed finds somebody else's thing there: it serves on, and is found again when
// that is gone.
TEST_F(Squatted, WhileItsServerRuns) {
    EXPECT_EQ(asNobody([&] {
                  ipc::Server server({.instance = instance.name(), .width = 8, .height = 8});
                  ipc::Client client(instance.name());
                  const auto answers = [&] {
                      ipc::Ticket ticket = 0;
                      client.send("x", &ticket);
                      for (const auto end = Clock::now() + 1500ms; Clock::now() < end;) {
                          server.wait(2ms);
                          for (const ipc::Command& command : server.takeCommands()) server.answer(command);
                      }
                      return client.wait(ticket, 0ms).status == ipc::ReplyStatus::Done;
                  };
                  ipc::Segment::remove(path.substr(9));
                  std::filesystem::create_directory(path); // as much in the way as another user's would be
                  if (!answers()) return 2;
                  std::filesystem::remove(path);
                  if (!answers() && !answers()) return 3; // the first is lost with the old epoch
                  return problemOf([&] { const ipc::Viewer viewer(instance.name(), 100ms); }) == 90 ? 0 : 4;
              }),
              0);
}

} // namespace
