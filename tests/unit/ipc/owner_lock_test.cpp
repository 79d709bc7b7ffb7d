#include "ipc/platform/owner_lock.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

using namespace ipc;

// What another process sees: 0 free, 1 held by us, 2 held by somebody else.
int seenByAnother(const std::string& path) {
    const pid_t child = ::fork();
    if (child == 0) {
        const LockHolder holder = lockHolder(path);
        ::_exit(!holder.held ? 0 : holder.process == ::getppid() ? 1 : 2);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WEXITSTATUS(status);
}

TEST(OwnerLock, HasOneOwnerInAndOutOfTheProcess) {
    const test::TemporaryFolder folder;
    const std::string path = folder / "a.lock";
    EXPECT_FALSE(lockHolder(path).held);
    {
        const auto lock = OwnerLock::tryTake(path);
        ASSERT_TRUE(lock);
        EXPECT_FALSE(OwnerLock::tryTake(path));
        EXPECT_TRUE(lockHolder(path).held);
        EXPECT_EQ(lockHolder(path).process, processId());
        // Asking and failing must not have dropped it, as closing any descriptor of the file would.
        EXPECT_EQ(seenByAnother(path), 1);
    }
    EXPECT_FALSE(lockHolder(path).held);
    EXPECT_EQ(seenByAnother(path), 0);
    EXPECT_TRUE(OwnerLock::tryTake(path));
}

TEST(OwnerLock, IsPrivateAndNoticesThatItsFileWasRemoved) {
    const test::TemporaryFolder folder;
    const std::string path = folder / "a.lock";
    const auto lock = OwnerLock::tryTake(path);
    struct stat facts {};
    ASSERT_EQ(::stat(path.c_str(), &facts), 0);
    EXPECT_EQ(facts.st_mode & 0777, 0600u);
    EXPECT_TRUE(lock->stands());
    std::filesystem::remove(path);
    EXPECT_FALSE(lock->stands());
    std::ofstream(path) << "another";
    EXPECT_FALSE(lock->stands());
}

TEST(OwnerLock, OfADeadProcessIsFree) {
    const test::TemporaryFolder folder;
    const std::string path = folder / "a.lock";
    int ready[2];
    ASSERT_EQ(::pipe(ready), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        const auto lock = OwnerLock::tryTake(path);
        [[maybe_unused]] const auto n = ::write(ready[1], "x", 1);
        ::pause();
    }
    char c = 0;
    ASSERT_EQ(::read(ready[0], &c, 1), 1);
    EXPECT_EQ(lockHolder(path).process, child);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    EXPECT_FALSE(lockHolder(path).held);
    ::close(ready[0]);
    ::close(ready[1]);
}

} // namespace
