/// Files and folders that no other user may look into.
#include "common/process/private_files.h"

#include "rtcore/platform/error.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;

class PrivateFiles : public testing::Test {
  protected:
    PrivateFiles() : before_(::umask(022)) {}
    ~PrivateFiles() override { ::umask(before_); }
    static unsigned modeOf(const fs::path& path) {
        struct stat facts {};
        EXPECT_EQ(::lstat(path.c_str(), &facts), 0) << path;
        return facts.st_mode & 0777U;
    }
    std::string path(const std::string& name = "tokens") const { return (folder / name).string(); }
    std::ptrdiff_t files() const { return std::distance(fs::directory_iterator(folder.path()), {}); }

    test::TemporaryFolder folder;

  private:
    mode_t before_;
};

TEST_F(PrivateFiles, AreWrittenOnceAndReadBack) {
    EXPECT_EQ(app::readPrivateFile(path()), std::nullopt);
    EXPECT_TRUE(app::writePrivateFile(path(), "first"));
    EXPECT_FALSE(app::writePrivateFile(path(), "second"));
    EXPECT_EQ(app::readPrivateFile(path()), "first");
    EXPECT_EQ(modeOf(path()), 0600U);
    EXPECT_EQ(files(), 1) << "nothing beside it";
}

TEST_F(PrivateFiles, AnEmptyOneIsAsNone) {
    std::ofstream(path()).close();
    fs::permissions(path(), fs::perms::owner_read | fs::perms::owner_write);
    EXPECT_EQ(app::readPrivateFile(path()), std::nullopt);
    EXPECT_TRUE(app::writePrivateFile(path(), "text"));
    EXPECT_EQ(app::readPrivateFile(path()), "text");
    EXPECT_EQ(modeOf(path()), 0600U);
}

TEST_F(PrivateFiles, DoNotGoThroughLinks) {
    std::ofstream(path("precious")) << "mine";
    std::ofstream(path("empty")).close();
    for (const char* end : {"precious", "empty", "nothing"}) {
        fs::create_symlink(end, path());
        EXPECT_FALSE(app::writePrivateFile(path(), "text")) << end;
        EXPECT_TRUE(fs::is_symlink(path()));
        fs::remove(path());
    }
    EXPECT_EQ(fs::file_size(path("precious")), 4U);
    EXPECT_EQ(fs::file_size(path("empty")), 0U);
    EXPECT_FALSE(fs::exists(path("nothing")));
}

TEST_F(PrivateFiles, AFullDiskLeavesNone) {
    rlimit limit{};
    ::getrlimit(RLIMIT_FSIZE, &limit);
    const rlimit full{4, limit.rlim_max};
    std::signal(SIGXFSZ, SIG_IGN);
    ::setrlimit(RLIMIT_FSIZE, &full);
    EXPECT_THROW(app::writePrivateFile(path(), "more than four"), rtcore::FileError);
    ::setrlimit(RLIMIT_FSIZE, &limit);
    EXPECT_EQ(files(), 0);
    EXPECT_TRUE(app::writePrivateFile(path(), "more than four"));
}

TEST_F(PrivateFiles, OfManyWritersOneWins) {
    for (int round = 0; round < 50; ++round) {
        if (round % 2 == 1) {
            std::ofstream(path()).close();
            fs::permissions(path(), fs::perms::owner_read | fs::perms::owner_write);
        }
        std::vector<int> won(4);
        {
            std::vector<std::jthread> writers;
            for (int i = 0; i < 4; ++i) {
                writers.emplace_back([&, i] {
                    won[static_cast<std::size_t>(i)] =
                        app::writePrivateFile(path(), std::to_string(i)) ? 1 : 0;
                });
            }
        }
        int winners = 0;
        for (int i = 0; i < 4; ++i) {
            if (won[static_cast<std::size_t>(i)] == 0) continue;
            ++winners;
            EXPECT_EQ(app::readPrivateFile(path()), std::to_string(i));
        }
        EXPECT_EQ(winners, 1) << round;
        fs::remove(path());
    }
}

TEST_F(PrivateFiles, FoldersAreMadeForOneUserAndNarrowed) {
    EXPECT_TRUE(app::makePrivateFolder(path("a/b/c")));
    for (const char* name : {"a", "a/b", "a/b/c"}) EXPECT_EQ(modeOf(path(name)), 0700U) << name;
    fs::permissions(path("a/b/c"), fs::perms::all);
    EXPECT_TRUE(app::makePrivateFolder(path("a/b/c")));
    EXPECT_EQ(modeOf(path("a/b/c")), 0700U);
    std::ofstream(path("file")) << "content";
    EXPECT_FALSE(app::makePrivateFolder(path("file")));
    EXPECT_EQ(modeOf(path("file")), 0644U);
    EXPECT_TRUE(app::makePrivateFile(path("file")));
    EXPECT_EQ(modeOf(path("file")), 0600U);
    EXPECT_EQ(fs::file_size(path("file")), 7U);
    EXPECT_TRUE(app::makePrivateFile(path("new")));
    EXPECT_EQ(modeOf(path("new")), 0600U);
    fs::create_symlink("nothing", path("link"));
    EXPECT_FALSE(app::makePrivateFile(path("link")));
    EXPECT_FALSE(fs::exists(path("nothing")));
}

} // namespace
