/// Who may do what with a file that was replaced, which links are followed, and what is kept of old ones.
#include "rtcore/platform/append_file.h"
#include "rtcore/platform/backups.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"
#include "rtcore/platform/paths.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <string>

#include <sys/stat.h>
#include <sys/wait.h>
#include <sys/xattr.h>
#include <unistd.h>

namespace fs = std::filesystem;
using rtcore::FailureKind;
using rtcore::FileError;

namespace {

constexpr uid_t kNobody = 65534;

struct stat factsOf(const fs::path& path) {
    struct stat facts {};
    EXPECT_EQ(::lstat(path.c_str(), &facts), 0) << path;
    return facts;
}
unsigned modeOf(const fs::path& path) { return factsOf(path).st_mode & 0777U; }

void putText(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }
void putText(const fs::path& path, const std::string& text, mode_t mode) {
    putText(path, text);
    ASSERT_EQ(::chmod(path.c_str(), mode), 0);
}
std::string textIn(const fs::path& path) { return rtcore::readTextFile(path); }

void replaceText(const fs::path& path, const std::string& text) {
    const std::array pieces{std::as_bytes(std::span(text))};
    rtcore::writeFileAtomically(path, pieces);
}

/// The message that it ends with; "" when it ends well.
std::string refusalOf(const std::function<void()>& act) {
    try {
        act();
    } catch (const FileError& error) {
        EXPECT_EQ(error.kind, FailureKind::CannotWrite);
        return error.what();
    }
    return "";
}

/// Whether a process of nobody's, in no group, ends it well.
bool nobodyCan(const std::function<bool()>& act) {
    const pid_t child = ::fork();
    if (child == 0) {
        if (::setgid(kNobody) != 0 || ::setuid(kNobody) != 0) ::_exit(2);
        bool good = false;
        try {
            good = act();
        } catch (const std::exception&) {
        }
        ::_exit(good ? 0 : 1);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_NE(WEXITSTATUS(status), 2);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

class ReplacedFile : public testing::Test {
  protected:
    ReplacedFile() : before_(::umask(022)) {}
    ~ReplacedFile() override { ::umask(before_); }
    test::TemporaryFolder folder;

  private:
    mode_t before_;
};

class ReplacedFileOfAnother : public ReplacedFile {
  protected:
    void SetUp() override {
        if (::getuid() != 0) GTEST_SKIP() << "only root can be two users";
        ASSERT_EQ(::chmod(folder.path().c_str(), 0755), 0);
    }
};

TEST_F(ReplacedFile, KeepsItsMode) {
    for (const mode_t mode : {0600, 0640, 0644, 0444, 0666, 0755, 0604}) {
        const fs::path path = folder / "f";
        fs::remove(path);
        putText(path, "old", mode);
        rtcore::replaceFile(path, [&](const fs::path& temporary) {
            EXPECT_EQ(modeOf(temporary), 0600U) << "nobody looks into it before";
            putText(temporary, "new");
        });
        EXPECT_EQ(textIn(path), "new");
        EXPECT_EQ(modeOf(path), mode);
    }
    putText(folder / "f", "old", 04755);
    replaceText(folder / "f", "new");
    EXPECT_EQ(factsOf(folder / "f").st_mode & 07777U, 0755U) << "what it runs as goes with its old content";
}

TEST_F(ReplacedFile, KeepsItsModeBehindALinkAndWhenTheWriterPutsAnotherFile) {
    putText(folder / "f", "old", 0600);
    fs::create_symlink("f", folder / "link");
    rtcore::replaceFile(folder / "link", [&](const fs::path& temporary) {
        putText(folder / "other", "new");
        fs::rename(folder / "other", temporary);
    });
    EXPECT_EQ(textIn(folder / "f"), "new");
    EXPECT_EQ(modeOf(folder / "f"), 0600U);
}

TEST_F(ReplacedFile, KeepsItsAccessList) {
    // Version 2; owner rw-, user nobody r--, group ---, mask r--, others ---: its mode reads 0640.
    struct Entry {
        std::uint16_t tag, rights;
        std::uint32_t id;
    };
    constexpr std::uint32_t kNone = 0xFFFFFFFFU;
    struct List {
        std::uint32_t version = 2;
        std::array<Entry, 5> entries{
            {{0x01, 6, kNone}, {0x02, 4, kNobody}, {0x04, 0, kNone}, {0x10, 4, kNone}, {0x20, 0, kNone}}};
    } list;
    const char* const name = "system.posix_acl_access";
    putText(folder / "f", "old", 0600);
    if (::setxattr((folder / "f").c_str(), name, &list, sizeof list, 0) != 0)
        GTEST_SKIP() << "no access lists here";
    replaceText(folder / "f", "new");
    List now{.version = 0, .entries = {}};
    ASSERT_EQ(::getxattr((folder / "f").c_str(), name, &now, sizeof now), static_cast<ssize_t>(sizeof now));
    for (std::size_t i = 0; i < list.entries.size(); ++i) {
        EXPECT_EQ(now.entries[i].tag, list.entries[i].tag);
        EXPECT_EQ(now.entries[i].rights, list.entries[i].rights);
    }
    // One that the folder would give is not added.
    ASSERT_EQ(::setxattr(folder.path().c_str(), "system.posix_acl_default", &list, sizeof list, 0), 0);
    fs::remove(folder / "f");
    putText(folder / "f", "old");
    ::removexattr((folder / "f").c_str(), name);
    ASSERT_EQ(::chmod((folder / "f").c_str(), 0640), 0);
    replaceText(folder / "f", "new");
    EXPECT_LT(::getxattr((folder / "f").c_str(), name, &now, sizeof now), 0);
    EXPECT_EQ(modeOf(folder / "f"), 0640U);
}

TEST_F(ReplacedFileOfAnother, StaysTheirsWhenTheSystemsOwnerReplacesIt) {
    putText(folder / "f", "old", 0640);
    ASSERT_EQ(::chown((folder / "f").c_str(), kNobody, 12), 0);
    replaceText(folder / "f", "new");
    EXPECT_EQ(factsOf(folder / "f").st_uid, kNobody);
    EXPECT_EQ(factsOf(folder / "f").st_gid, 12U);
    EXPECT_EQ(modeOf(folder / "f"), 0640U);
}

TEST_F(ReplacedFileOfAnother, LosesTheRightsOfAGroupThatItCannotKeep) {
    ASSERT_EQ(::chmod(folder.path().c_str(), 0777), 0);
    for (const auto& [mode, left] : {std::pair<mode_t, mode_t>{0660, 0600}, {0664, 0644}, {0604, 0600}}) {
        putText(folder / "f", "old", mode);
        ASSERT_EQ(::chown((folder / "f").c_str(), 0, 12), 0);
        EXPECT_TRUE(nobodyCan([&] {
            replaceText(folder / "f", "new");
            return true;
        }));
        EXPECT_EQ(factsOf(folder / "f").st_uid, kNobody);
        EXPECT_EQ(modeOf(folder / "f"), left) << std::oct << mode;
        fs::remove(folder / "f");
    }
}

// --- Links ---

TEST_F(ReplacedFileOfAnother, IsNotReachedByLinksThatOthersPutWhereAllMayWrite) {
    fs::create_directory(folder / "all");
    fs::create_directory(folder / "mine");
    putText(folder / "mine/precious", "mine");
    for (const mode_t mode : {01777, 0777, 01757}) {
        ASSERT_EQ(::chmod((folder / "all").c_str(), mode), 0);
        for (const char* end : {"mine/precious", "mine/new", "mine"}) {
            const fs::path link = folder / "all/now.png";
            fs::create_symlink(folder / end, link);
            ASSERT_EQ(::lchown(link.c_str(), kNobody, kNobody), 0);
            const fs::path output = std::string(end) == "mine" ? link / "precious" : link;
            EXPECT_NE(refusalOf([&] { replaceText(output, "theirs"); }).find("another user put"),
                      std::string::npos)
                << end;
            ASSERT_EQ(::lchown(link.c_str(), 0, 0), 0);
            EXPECT_EQ(refusalOf([&] { replaceText(output, "mine"); }), "") << "one's own is followed";
            fs::remove(link);
        }
        EXPECT_EQ(textIn(folder / "mine/precious"), "mine");
        fs::remove(folder / "mine/new");
    }
}

TEST_F(ReplacedFileOfAnother, IsNotMadeByAppendingBehindLinksThatOthersPut) {
    fs::create_directory(folder / "all");
    fs::create_directory(folder / "mine");
    const fs::path link = folder / "all/logs";
    const auto append = [&] { rtcore::AppendFile(link / "log").append("line\n"); };
    for (const mode_t mode : {01777, 0777, 01757}) {
        ASSERT_EQ(::chmod((folder / "all").c_str(), mode), 0);
        fs::create_symlink(folder / "mine", link);
        ASSERT_EQ(::lchown(link.c_str(), kNobody, kNobody), 0);
        EXPECT_NE(refusalOf(append).find("another user put"), std::string::npos);
        EXPECT_FALSE(fs::exists(folder / "mine/log"));
        ASSERT_EQ(::lchown(link.c_str(), 0, 0), 0);
        EXPECT_EQ(refusalOf(append), "") << "one's own is followed";
        fs::remove(folder / "mine/log");
        fs::remove(link);
    }
    ASSERT_EQ(::chmod((folder / "all").c_str(), 0755), 0);
    fs::create_symlink(folder / "mine", link);
    ASSERT_EQ(::lchown(link.c_str(), kNobody, kNobody), 0);
    EXPECT_EQ(refusalOf(append), "") << "which only the folder's owner could put";
}

TEST_F(ReplacedFileOfAnother, IsReachedByLinksThatOnlyTheirOwnerCouldPut) {
    putText(folder / "precious", "old");
    fs::create_symlink("precious", folder / "link");
    ASSERT_EQ(::lchown((folder / "link").c_str(), kNobody, kNobody), 0);
    EXPECT_EQ(refusalOf([&] { replaceText(folder / "link", "new"); }), "");
    EXPECT_EQ(textIn(folder / "precious"), "new");
}

// --- Old versions ---

TEST_F(ReplacedFile, IsKeptWithItsRightsUnderANameThatIsFree) {
    const fs::path path = folder / "a.scn";
    putText(folder / "precious", "somebody's");
    fs::create_symlink("precious", folder / "a.scn~");
    fs::create_symlink("nothing", folder / "a.scn~2");
    for (int i = 3; i <= 5; ++i) {
        fs::remove(path);
        putText(path, "version " + std::to_string(i), 0600);
        EXPECT_EQ(rtcore::keepBackup(path), folder / ("a.scn~" + std::to_string(i)));
        replaceText(path, "new");
    }
    for (int i = 3; i <= 5; ++i) {
        EXPECT_EQ(textIn(folder / ("a.scn~" + std::to_string(i))), "version " + std::to_string(i));
        EXPECT_EQ(modeOf(folder / ("a.scn~" + std::to_string(i))), 0600U);
    }
    EXPECT_EQ(textIn(folder / "precious"), "somebody's");
    EXPECT_FALSE(fs::exists(folder / "nothing"));
    EXPECT_TRUE(fs::is_symlink(folder / "a.scn~"));
}

TEST_F(ReplacedFile, IsKeptFromBehindALink) {
    fs::create_directory(folder / "real");
    putText(folder / "real/a.scn", "old", 0640);
    fs::create_symlink("real/a.scn", folder / "a.scn");
    EXPECT_EQ(rtcore::keepBackup(folder / "a.scn"), folder / "a.scn~");
    replaceText(folder / "a.scn", "new");
    EXPECT_FALSE(fs::is_symlink(folder / "a.scn~"));
    EXPECT_EQ(textIn(folder / "a.scn~"), "old");
    EXPECT_EQ(modeOf(folder / "a.scn~"), 0640U);
}

TEST_F(ReplacedFile, IsKeptOnAnotherFileSystem) {
    const test::TemporaryFolder elsewhere;
    const fs::path shared = "/dev/shm" / elsewhere.path().filename();
    if (!fs::exists("/dev/shm") || !fs::create_directory(shared)) GTEST_SKIP() << "there is no other one";
    putText(shared / "a.scn", "old", 0600);
    fs::create_symlink(shared / "a.scn", folder / "a.scn");
    EXPECT_EQ(rtcore::keepBackup(folder / "a.scn"), folder / "a.scn~");
    EXPECT_EQ(textIn(folder / "a.scn~"), "old");
    EXPECT_EQ(modeOf(folder / "a.scn~"), 0600U);
    fs::remove_all(shared);
}

TEST_F(ReplacedFile, IsKeptSoOftenAndNoMore) {
    putText(folder / "a.scn", "new");
    for (int i = 1; i <= rtcore::kMaxBackups; ++i)
        putText(folder / ("a.scn~" + (i == 1 ? std::string() : std::to_string(i))), "kept");
    EXPECT_NE(refusalOf([&] { rtcore::keepBackup(folder / "a.scn"); }).find("99 old versions"),
              std::string::npos);
}

// --- Names ---

TEST_F(ReplacedFile, PlainNamesLeadToTheSameFile) {
    fs::create_directories(folder / "a/b");
    fs::create_directories(folder / "c/d");
    putText(folder / "a/f", "a");
    putText(folder / "c/f", "c");
    fs::create_directory_symlink(folder / "c/d", folder / "a/link");
    EXPECT_EQ(rtcore::plainPath(folder / "a/b/.././f"), folder / "a/f");
    EXPECT_EQ(rtcore::plainPath(folder / "a/link/../f"), folder / "a/link/../f") << "c/f";
    EXPECT_EQ(rtcore::plainPath(folder / "a/b/../later"), folder / "a/later");
    EXPECT_EQ(rtcore::plainPath(folder / "a/link/../later"), folder / "a/link/../later");
    EXPECT_EQ(rtcore::plainPath("f"), fs::current_path() / "f");
}

} // namespace
