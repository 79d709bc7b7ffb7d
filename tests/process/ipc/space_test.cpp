/// Shared memory that is too small. Each test has a /dev/shm of its own, in a process with its own mounts;
/// needs root.
#include "ipc/endpoint/client.h"
#include "ipc/endpoint/server.h"
#include "process/ipc/troupe.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sched.h>
#include <sys/mount.h>

namespace {

using namespace test;

constexpr int kNotAllowed = 99;

// Exit code of `body` where shared memory has this size; a signal counts as 128 and more.
int withSharedMemory(const char* size, const std::function<int()>& body) {
    const pid_t child = ::fork();
    if (child == 0) {
        if (::unshare(CLONE_NEWNS) != 0 || ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
            ::mount("tmpfs", "/dev/shm", "tmpfs", 0, (std::string("size=") + size).c_str()) != 0) {
            ::_exit(kNotAllowed);
        }
        ::_exit(body());
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

class Space : public testing::Test {
  protected:
    void SetUp() override {
        if (withSharedMemory("1m", [] { return 0; }) == kNotAllowed)
            GTEST_SKIP() << "no mounts of our own: not root";
    }
    test::IpcInstance instance;
};

ipc::Problem problemOf(const std::function<void()>& act, std::string* text = nullptr) {
    try {
        act();
    } catch (const ipc::Error& error) {
        if (text != nullptr) *text = error.what();
        return error.problem;
    }
    return ipc::Problem::System;
}

TEST_F(Space, TooLittleForAServerIsAnError) {
    for (const char* size : {"4k", "64k", "1m", "4m"}) {
        EXPECT_EQ(withSharedMemory(size,
                                   [&] {
                                       std::string text;
                                       const auto problem = problemOf(
                                           [&] {
                                               const ipc::Server server({.instance = instance.name(),
                                                                         .width = 1920,
                                                                         .height = 1080});
                                           },
                                           &text);
                                       if (problem != ipc::Problem::NoSpace) return 1;
                                       if (text.find("needs ") == std::string::npos) return 2;
                                       return instance.segments().empty() ? 0 : 3;
                                   }),
                  0)
            << size;
    }
}

TEST_F(Space, TooLittleForALargerFrameLeavesTheServerRunning) {
    EXPECT_EQ(withSharedMemory(
                  "16m",
                  [&] {
                      ipc::Server server({.instance = instance.name(), .width = 640, .height = 480});
                      ipc::Viewer viewer(instance.name());
                      ipc::Frame frame;
                      for (int i = 0; i < 20; ++i) {
                          server.beginFrame(640, 480);
                          server.publishFrame();
                          if (problemOf([&] { server.beginFrame(3840, 2160); }) != ipc::Problem::NoSpace)
                              return 1;
                          if (!viewer.readFrame(frame)) return 2;
                      }
                      return frame.info.number == 20 ? 0 : 3;
                  }),
              0);
}

TEST_F(Space, FilledByOthersHitsOnlyNewcomers) {
    EXPECT_EQ(withSharedMemory(
                  "8m",
                  [&] {
                      ipc::Server server({.instance = instance.name(), .width = 64, .height = 64});
                      ipc::Client first(instance.name());
                      server.takeCommands();
                      const int filler = ::open("/dev/shm/filler", O_RDWR | O_CREAT, 0600);
                      const std::vector<char> block(4096);
                      while (::write(filler, block.data(), block.size()) > 0) {
                      }
                      for (int i = 0; i < 30; ++i) {
                          server.beginFrame(64, 64);
                          server.publishFrame();
                          if (first.send(std::string(8000, 'x')) != ipc::SendStatus::Sent) return 1;
                          if (server.takeCommands().size() != 1) return 2;
                      }
                      const auto problem = problemOf([&] { const ipc::Client second(instance.name()); });
                      return problem == ipc::Problem::NoSpace ? 0 : 3;
                  }),
              0);
}

} // namespace
