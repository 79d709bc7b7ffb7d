/// Segments: what lies in the way of their names, and the locks on their bytes.
#include "ipc/platform/error.h"
#include "ipc/platform/segment.h"
#include "support/ipc_instance.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

using namespace ipc;

class Segments : public testing::Test {
  protected:
    // Whether another process sees a lock on byte 5.
    bool lockedForAnother() const {
        const pid_t child = ::fork();
        if (child == 0) ::_exit(Segment::open(name, Access::Read, 0)->locked(5) ? 1 : 0);
        int status = 0;
        ::waitpid(child, &status, 0);
        return WEXITSTATUS(status) == 1;
    }
    std::optional<Problem> problem() const {
        try {
            Segment::open(name, Access::Read, 0);
        } catch (const Error& error) {
            return error.problem;
        }
        return std::nullopt;
    }
    test::IpcInstance instance;
    const std::string name = instance.names().control(), path = "/dev/shm/" + name;
};

TEST_F(Segments, ALockHasOneOwnerInAndOutOfTheProcess) {
    const Segment segment = Segment::create(name, 100);
    auto other = Segment::open(name, Access::Write, 100);
    EXPECT_FALSE(other->locked(5));
    ASSERT_TRUE(segment.tryLock(5));
    EXPECT_FALSE(segment.locked(5)) << "by somebody else";
    EXPECT_TRUE(other->locked(5));
    EXPECT_FALSE(other->tryLock(5));
    EXPECT_TRUE(other->tryLock(6)) << "each byte is its own";
    EXPECT_TRUE(lockedForAnother());
    segment.unlock(5);
    EXPECT_FALSE(lockedForAnother());
    EXPECT_TRUE(other->tryLock(5));
}

// As a program does that looks into every file of a folder.
TEST_F(Segments, ALockOutlivesItsNameAndOtherDescriptors) {
    const Segment segment = Segment::create(name, 100);
    ASSERT_TRUE(segment.tryLock(5));
    for (int i = 0; i < 3; ++i) {
        std::fstream(path, std::ios::in | std::ios::out).get();
        EXPECT_TRUE(Segment::open(name, Access::Write, 100)->locked(5));
    }
    const auto other = Segment::open(name, Access::Read, 100);
    Segment::remove(name);
    EXPECT_FALSE(segment.named());
    EXPECT_TRUE(other->locked(5));
}

TEST_F(Segments, ALockOfADeadProcessIsFree) {
    const Segment segment = Segment::create(name, 100);
    int ready[2];
    ASSERT_EQ(::pipe(ready), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        const auto own = Segment::open(name, Access::Write, 100);
        [[maybe_unused]] const auto n = ::write(ready[1], own->tryLock(5) ? "x" : "", 1);
        ::pause();
    }
    char c = 0;
    ASSERT_EQ(::read(ready[0], &c, 1), 1);
    EXPECT_TRUE(segment.locked(5));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    EXPECT_FALSE(segment.locked(5));
    ::close(ready[0]);
    ::close(ready[1]);
}

// Those of 1.81 and before waited here for a writer, for ever.
TEST_F(Segments, NothingAtANameIsWaitedFor) {
    ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
    EXPECT_EQ(problem(), Problem::NotYours);
    std::filesystem::remove(path);
    std::filesystem::create_symlink("/dev/zero", path);
    EXPECT_EQ(problem(), Problem::NotYours);
    std::filesystem::remove(path);
    std::filesystem::create_directory(path);
    EXPECT_EQ(problem(), Problem::NotYours);
    std::filesystem::remove(path);
    EXPECT_EQ(problem(), std::nullopt);
}

TEST_F(Segments, ALockedOneIsMadeOnce) {
    const auto first = Segment::createLocked(name, 100, 0);
    ASSERT_TRUE(first);
    EXPECT_EQ(first->bytes(), 100U);
    EXPECT_TRUE(lockedForAnother() == false && Segment::open(name, Access::Read, 0)->locked(0));
    EXPECT_FALSE(Segment::createLocked(name, 100, 0));
}

} // namespace
