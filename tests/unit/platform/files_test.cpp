#include "rtcore/platform/files.h"

#include "rtcore/platform/error.h"
#include "rtcore/platform/file_waits.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;
using rtcore::FailureKind;
using rtcore::FileError;

namespace {

std::span<const std::byte> bytesOf(const std::string& text) { return std::as_bytes(std::span(text)); }

std::string textOf(const rtcore::FileBytes& file) {
    return {reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()};
}

void put(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

void replaceBy(const fs::path& path, const std::string& text) {
    const std::array pieces{bytesOf(text)};
    rtcore::writeFileAtomically(path, pieces);
}

std::size_t entries(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

/// The error that `action` ends with; fails the test when it ends well.
template <typename Action>
FileError errorOf(Action action) {
    try {
        action();
    } catch (const FileError& error) {
        return error;
    }
    ADD_FAILURE() << "no FileError";
    return {FailureKind::Stopped, "", ""};
}

/// Runs `action` in a child process; its exit code, or minus the signal that ended it.
template <typename Action>
int inChild(Action action) {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(action());
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

/// The answer of a program that has been asked to stop.
bool yes() noexcept { return true; }

/// In a child: whether `action` ends with such an error, soon after it has been asked to stop.
template <typename Action>
bool endsWith(FailureKind kind, void (*prepare)(), Action action) {
    return inChild([&] {
               ::alarm(20);
               prepare();
               try {
                   action();
               } catch (const FileError& error) {
                   return error.kind == kind ? 0 : 2;
               }
               return 1;
           }) == 0;
}

} // namespace

TEST(OpenFileBytes, GivesSmallAndMappedFilesAsTheyAre) {
    const test::TemporaryFolder folder;
    for (const std::size_t size : {0, 1, 4095, 65535, 65536, 300000}) {
        std::string content(size, '\0');
        for (std::size_t i = 0; i < size; ++i) content[i] = static_cast<char>(i * 7 + i / 251);
        put(folder / "f", content);
        EXPECT_EQ(textOf(rtcore::openFileBytes(folder / "f")), content) << size;
    }
}

TEST(OpenFileBytes, ContentLivesAsLongAsItsOwnerThoughTheFileIsReplaced) {
    const test::TemporaryFolder folder;
    const std::string before(100000, 'a');
    put(folder / "f", before);
    const rtcore::FileBytes bytes = rtcore::openFileBytes(folder / "f");
    replaceBy(folder / "f", "new");
    fs::remove(folder / "f");
    EXPECT_EQ(textOf(bytes), before);
}

TEST(OpenFileBytes, ContentStaysThoughTheFileIsWrittenOver) {
    const test::TemporaryFolder folder;
    const std::string before(300000, 'a');
    put(folder / "f", before);
    const rtcore::FileBytes bytes = rtcore::openFileBytes(folder / "f");
    put(folder / "f", std::string(300000, 'b'));
    EXPECT_EQ(textOf(bytes), before);
    put(folder / "f", "");
    EXPECT_EQ(textOf(bytes), before);
}

TEST(OpenFileBytes, MapsWhatIsLargerThanAGigabyte) {
    const test::TemporaryFolder folder;
    put(folder / "f", "head");
    constexpr std::uintmax_t size = (std::uintmax_t{1} << 30) + 5000;
    fs::resize_file(folder / "f", size);
    const rtcore::FileBytes bytes = rtcore::openFileBytes(folder / "f");
    ASSERT_EQ(bytes.bytes.size(), size);
    EXPECT_EQ(bytes.bytes[0], std::byte{'h'});
    EXPECT_EQ(bytes.bytes.back(), std::byte{0});
}

TEST(InputFile, IsLookedIntoAndReadAsOneFile) {
    const test::TemporaryFolder folder;
    const std::string content = std::string(100000, 'x') + "end";
    put(folder / "f", content);
    rtcore::InputFile file(folder / "f");
    EXPECT_EQ(file.head(4).size(), 4U);
    fs::remove(folder / "f");
    put(folder / "f", "another");
    EXPECT_EQ(file.head(1 << 20).size(), content.size());
    EXPECT_EQ(textOf(file.read()), content);
}

TEST(InputFile, IsCopiedInPiecesAlsoWhenItShrinks) {
    const test::TemporaryFolder folder;
    put(folder / "f", "0123456789");
    const rtcore::InputFile file(folder / "f");
    EXPECT_EQ(file.size(), 10U);
    std::string piece(4, ' ');
    EXPECT_EQ(file.readAt(5, std::as_writable_bytes(std::span(piece))), 4U);
    EXPECT_EQ(piece, "5678");
    fs::resize_file(folder / "f", 7);
    EXPECT_EQ(file.readAt(5, std::as_writable_bytes(std::span(piece))), 2U);
    EXPECT_EQ(piece.substr(0, 2), "56");
    EXPECT_EQ(file.readAt(9, std::as_writable_bytes(std::span(piece))), 0U);
}

TEST(InputFile, LooksIntoAPipeAndReadsItOnce) {
    const test::TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    const std::string content(200000, 'p');
    std::thread writer([&] { put(folder / "pipe", content); });
    rtcore::InputFile file(folder / "pipe");
    EXPECT_EQ(file.head(10).size(), 10U);
    EXPECT_EQ(textOf(file.read()), content);
    writer.join();
}

TEST(LineReader, GivesLinesAsTheyCome) {
    const test::TemporaryFolder folder;
    const auto linesOf = [&](const std::string& text) {
        put(folder / "f", text);
        rtcore::LineReader reader(folder / "f");
        std::vector<std::string> lines;
        while (auto line = reader.next()) lines.push_back(*line);
        return lines;
    };
    using Lines = std::vector<std::string>;
    EXPECT_EQ(linesOf(""), Lines{});
    EXPECT_EQ(linesOf("\n"), Lines{""});
    EXPECT_EQ(linesOf("a\n\nb"), (Lines{"a", "", "b"}));
    const std::string longLine(10000, 'x');
    EXPECT_EQ(linesOf(longLine + "\nend\n"), (Lines{longLine, "end"}));
    EXPECT_EQ(errorOf([&] { linesOf(std::string((1 << 20) + 5000, 'x')); }).kind, FailureKind::BadData);
    EXPECT_EQ(errorOf([&] { rtcore::LineReader reader(folder.path()); }).kind, FailureKind::NoInput);
    EXPECT_EQ(errorOf([&] { rtcore::LineReader reader(folder / "none"); }).kind, FailureKind::NoInput);

    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    const int writer = ::open((folder / "pipe").c_str(), O_RDWR | O_CLOEXEC);
    ASSERT_EQ(::write(writer, "one\ntw", 6), 6);
    rtcore::LineReader reader(folder / "pipe");
    EXPECT_EQ(reader.next(), "one") << "though the pipe is still open";
    ASSERT_EQ(::write(writer, "o\n", 2), 2);
    EXPECT_EQ(reader.next(), "two");
    EXPECT_TRUE(endsWith(
        FailureKind::Stopped, [] { rtcore::interruptFilesBy(yes); }, [&] { reader.next(); }));
    ::close(writer);
}

TEST(StoredBytes, CountsNoHoles) {
    const test::TemporaryFolder folder;
    put(folder / "f", std::string(100000, 'x'));
    EXPECT_GE(rtcore::storedBytes(folder / "f"), 100000U);
    EXPECT_LT(rtcore::storedBytes(folder / "f"), 200000U);
    fs::resize_file(folder / "f", 5'000'000'000);
    EXPECT_LT(rtcore::storedBytes(folder / "f"), 1'000'000U);
    put(folder / "hole", "");
    fs::resize_file(folder / "hole", 5'000'000'000);
    EXPECT_EQ(rtcore::storedBytes(folder / "hole"), 0U);
    EXPECT_EQ(rtcore::storedBytes(folder / "missing"), 0U);
}

TEST(FileIdentity, IsTheFilesWhateverItsName) {
    const test::TemporaryFolder folder;
    put(folder / "f", "x");
    put(folder / "g", "x");
    fs::create_hard_link(folder / "f", folder / "hard");
    fs::create_symlink("f", folder / "soft");
    const auto f = rtcore::identityOf(folder / "f");
    ASSERT_TRUE(f);
    EXPECT_EQ(f, rtcore::identityOf(folder / "hard"));
    EXPECT_EQ(f, rtcore::identityOf(folder / "soft"));
    EXPECT_NE(f, rtcore::identityOf(folder / "g"));
    EXPECT_FALSE(rtcore::identityOf(folder / "missing"));
}

TEST(FileWaits, EndWhenTheProgramIsAskedToStop) {
    const test::TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    const auto ask = [] { rtcore::interruptFilesBy(yes); };
    EXPECT_TRUE(endsWith(FailureKind::Stopped, ask, [&] { rtcore::readTextFile(folder / "pipe"); }))
        << "nobody writes";
    EXPECT_TRUE(endsWith(FailureKind::Stopped, ask, [&] { replaceBy(folder / "pipe", "x"); }))
        << "nobody reads";
    // A partner that does nothing.
    const int partner = ::open((folder / "pipe").c_str(), O_RDWR | O_CLOEXEC);
    ASSERT_GE(partner, 0);
    ASSERT_EQ(::write(partner, "begun", 5), 5);
    EXPECT_TRUE(endsWith(FailureKind::Stopped, ask, [&] { rtcore::openFileBytes(folder / "pipe"); }));
    EXPECT_TRUE(
        endsWith(FailureKind::Stopped, ask, [&] { replaceBy(folder / "pipe", std::string(1 << 20, 'x')); }));
    ::close(partner);
}

TEST(FileWaits, RegularFilesOnlyRefuseTheRestAtOnce) {
    const test::TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    put(folder / "f", "x");
    const auto restrict = [] { rtcore::allowRegularFilesOnly(); };
    EXPECT_TRUE(endsWith(FailureKind::NoInput, restrict, [&] { rtcore::readTextFile(folder / "pipe"); }));
    EXPECT_TRUE(endsWith(FailureKind::NoInput, restrict, [] { rtcore::openFileBytes("/dev/zero"); }));
    EXPECT_TRUE(endsWith(FailureKind::CannotWrite, restrict, [&] { replaceBy(folder / "pipe", "x"); }));
    EXPECT_TRUE(endsWith(FailureKind::CannotWrite, restrict, [] { replaceBy("/dev/null", "x"); }));
    EXPECT_EQ(inChild([&] {
                  restrict();
                  replaceBy(folder / "f", "new");
                  return rtcore::readTextFile(folder / "f") == "new" ? 0 : 1;
              }),
              0);
}

TEST(RemoveForgottenFiles, TakesOldOnesOfItsOwnKindOnly) {
    const test::TemporaryFolder folder;
    const std::string name = ".rtsuite-0123456789abcdef";
    const std::vector<std::string> foreign{
        ".rtsuite-0123456789abcdeg.png", ".rtsuite-012345.png", ".rtsuite-0123456789abcdef0.png",
        "rtsuite-0123456789abcdef.png",  ".rtsuite-",           "notes.txt"};
    for (const std::string& each : foreign) put(folder / each, "x");
    put(folder / (name + ".png"), "x");
    put(folder / name, "x");
    put(folder / "precious", "x");
    fs::create_symlink("precious", folder / ".rtsuite-00000000000000aa.png");
    fs::create_hard_link(folder / "precious", folder / ".rtsuite-00000000000000bb.png");
    fs::create_directory(folder / ".rtsuite-00000000000000cc.png");
    const std::size_t before = entries(folder.path());
    rtcore::removeForgottenFiles(folder.path());
    EXPECT_EQ(entries(folder.path()), before) << "they are young";
    rtcore::replaceFile(folder / "picture.png", [&](const fs::path& temporary) {
        rtcore::removeForgottenFiles(folder.path(), 0);
        EXPECT_TRUE(fs::exists(temporary)) << "somebody writes it";
    });
    EXPECT_EQ(entries(folder.path()), before - 2 + 1);
    EXPECT_FALSE(fs::exists(folder / (name + ".png")));
    EXPECT_FALSE(fs::exists(folder / name));
    for (const std::string& each : foreign) EXPECT_TRUE(fs::exists(folder / each)) << each;
    rtcore::removeForgottenFiles(folder / "missing", 0);
}

TEST(OpenFileBytes, ReadsPipesAndFilesWithoutASize) {
    const test::TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    const std::string content(200000, 'p');
    std::thread writer([&] { put(folder / "pipe", content); });
    EXPECT_EQ(textOf(rtcore::openFileBytes(folder / "pipe")), content);
    writer.join();
    if (fs::exists("/proc/self/status")) {
        EXPECT_NE(rtcore::readTextFile("/proc/self/status").find("Pid:"), std::string::npos);
    }
}

TEST(OpenFileBytes, NamesTheFileThatIsMissingOrAFolder) {
    const test::TemporaryFolder folder;
    const FileError missing = errorOf([&] { rtcore::openFileBytes(folder / "nothing"); });
    EXPECT_EQ(missing.kind, FailureKind::NoInput);
    EXPECT_NE(std::string(missing.what()).find("nothing: cannot be read"), std::string::npos)
        << missing.what();
    EXPECT_EQ(errorOf([&] { rtcore::openFileBytes(folder.path()); }).kind, FailureKind::NoInput);
    EXPECT_EQ(errorOf([&] { rtcore::openFileBytes(folder / "nothing" / "below"); }).kind,
              FailureKind::NoInput);
    if (::geteuid() == 0) return;
    put(folder / "secret", "x");
    fs::permissions(folder / "secret", fs::perms::none);
    EXPECT_EQ(errorOf([&] { rtcore::openFileBytes(folder / "secret"); }).kind, FailureKind::NoInput);
}

TEST(ReadTextFile, RefusesWhatIsLargerThanItsLimit) {
    const test::TemporaryFolder folder;
    put(folder / "f", "12345");
    EXPECT_EQ(rtcore::readTextFile(folder / "f", 5), "12345");
    EXPECT_EQ(errorOf([&] { rtcore::readTextFile(folder / "f", 4); }).kind, FailureKind::BadData);
    if (fs::exists("/dev/zero")) {
        EXPECT_EQ(errorOf([&] { rtcore::readTextFile("/dev/zero", 1000); }).kind, FailureKind::BadData);
    }
}

TEST(ReplaceFile, WritesPiecesInOrderAndLeavesNothingElse) {
    const test::TemporaryFolder folder;
    const std::string a = "one ", b, c(100000, 'c');
    const std::array pieces{bytesOf(a), bytesOf(b), bytesOf(c)};
    rtcore::writeFileAtomically(folder / "f", pieces);
    EXPECT_EQ(rtcore::readTextFile(folder / "f"), a + c);
    replaceBy(folder / "f", "short");
    EXPECT_EQ(rtcore::readTextFile(folder / "f"), "short");
    EXPECT_EQ(entries(folder.path()), 1U);
}

TEST(ReplaceFile, TemporaryFileIsEmptyBesideTheTargetAndKeepsItsExtension) {
    const test::TemporaryFolder folder;
    rtcore::replaceFile(folder / "picture.png", [&](const fs::path& temporary) {
        EXPECT_EQ(temporary.parent_path(), folder.path());
        EXPECT_EQ(temporary.extension(), ".png");
        EXPECT_EQ(fs::file_size(temporary), 0U);
        EXPECT_FALSE(fs::exists(folder / "picture.png"));
        put(temporary, "pixels");
    });
    EXPECT_EQ(rtcore::readTextFile(folder / "picture.png"), "pixels");
}

TEST(ReplaceFile, ModeFollowsTheUmask) {
    const test::TemporaryFolder folder;
    for (const mode_t mask : {0022, 0077, 0000}) {
        const fs::path path = folder / std::to_string(mask);
        EXPECT_EQ(inChild([&] {
                      ::umask(mask);
                      replaceBy(path, "x");
                      return 0;
                  }),
                  0);
        struct stat status {};
        ASSERT_EQ(::stat(path.c_str(), &status), 0);
        EXPECT_EQ(status.st_mode & 0777U, 0666U & ~mask);
    }
}

TEST(ReplaceFile, ExceptionLeavesTheOldContentAndNoTemporary) {
    const test::TemporaryFolder folder;
    put(folder / "f", "old");
    EXPECT_THROW(rtcore::replaceFile(folder / "f",
                                     [](const fs::path& temporary) {
                                         put(temporary, "half of the n");
                                         throw std::runtime_error("stopped");
                                     }),
                 std::runtime_error);
    EXPECT_EQ(rtcore::readTextFile(folder / "f"), "old");
    EXPECT_EQ(entries(folder.path()), 1U);
}

TEST(ReplaceFile, FollowsLinksToTheirEnd) {
    const test::TemporaryFolder folder;
    fs::create_directory(folder / "real");
    put(folder / "real" / "f", "old");
    fs::create_symlink("real/f", folder / "middle");
    fs::create_symlink(folder / "middle", folder / "link");
    replaceBy(folder / "link", "new");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_TRUE(fs::is_symlink(folder / "middle"));
    EXPECT_EQ(rtcore::readTextFile(folder / "real" / "f"), "new");
    EXPECT_EQ(entries(folder / "real"), 1U);

    fs::create_symlink("real/later", folder / "dangling");
    replaceBy(folder / "dangling", "made");
    EXPECT_EQ(rtcore::readTextFile(folder / "real" / "later"), "made");

    fs::create_symlink("circle", folder / "circle");
    EXPECT_EQ(errorOf([&] { replaceBy(folder / "circle", "x"); }).kind, FailureKind::CannotWrite);
}

TEST(ReplaceFile, RelativeNamesBelongToTheCurrentFolder) {
    const test::TemporaryFolder folder;
    EXPECT_EQ(inChild([&] {
                  if (::chdir(folder.path().c_str()) != 0) return 1;
                  replaceBy("plain.txt", "here");
                  return 0;
              }),
              0);
    EXPECT_EQ(rtcore::readTextFile(folder / "plain.txt"), "here");
}

TEST(ReplaceFile, WritesPipesDirectly) {
    const test::TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    std::string received;
    std::thread reader([&] { received = rtcore::readTextFile(folder / "pipe"); });
    replaceBy(folder / "pipe", "through the pipe");
    reader.join();
    EXPECT_EQ(received, "through the pipe");
    EXPECT_TRUE(fs::is_fifo(folder / "pipe"));
}

TEST(ReplaceFile, StandardOutputStaysTheSameFile) {
    if (!fs::exists("/dev/stdout")) GTEST_SKIP() << "no /dev/stdout";
    const test::TemporaryFolder folder;
    put(folder / "out", "");
    struct stat before {
    }, after{};
    ASSERT_EQ(::stat((folder / "out").c_str(), &before), 0);
    EXPECT_EQ(inChild([&] {
                  if (std::freopen((folder / "out").c_str(), "wb", stdout) == nullptr) return 1;
                  replaceBy("/dev/stdout", "result");
                  return 0;
              }),
              0);
    ASSERT_EQ(::stat((folder / "out").c_str(), &after), 0);
    EXPECT_EQ(before.st_ino, after.st_ino);
    EXPECT_EQ(rtcore::readTextFile(folder / "out"), "result");
    EXPECT_EQ(entries(folder.path()), 1U);
}

TEST(ReplaceFile, SaysWhyItCannotWrite) {
    const test::TemporaryFolder folder;
    const FileError noFolder = errorOf([&] { replaceBy(folder / "missing" / "f", "x"); });
    EXPECT_EQ(noFolder.kind, FailureKind::CannotWrite);
    EXPECT_NE(std::string(noFolder.what()).find("missing/f: cannot be written: No such file"),
              std::string::npos)
        << noFolder.what();
    EXPECT_EQ(errorOf([&] { replaceBy(folder.path(), "x"); }).kind, FailureKind::CannotWrite);
    EXPECT_EQ(errorOf([&] { replaceBy(folder / std::string(300, 'n'), "x"); }).kind,
              FailureKind::CannotWrite);
    EXPECT_EQ(entries(folder.path()), 0U);
}

TEST(ReplaceFile, FullDeviceIsAnError) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
    const FileError full = errorOf([] { replaceBy("/dev/full", "x"); });
    EXPECT_EQ(full.kind, FailureKind::CannotWrite);
    EXPECT_NE(std::string(full.what()).find("No space left"), std::string::npos) << full.what();
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST(ReplaceFile, UnwritableFolderIsAnError) {
    if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
    const test::TemporaryFolder folder;
    fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
    const FileError denied = errorOf([&] { replaceBy(folder / "f", "x"); });
    fs::permissions(folder.path(), fs::perms::owner_all);
    EXPECT_EQ(denied.kind, FailureKind::CannotWrite);
}

TEST(ReplaceFile, FileSizeLimitIsAnErrorAndLeavesTheOldFile) {
    const test::TemporaryFolder folder;
    put(folder / "f", "old");
    const int code = inChild([&] {
        const rlimit limit{1000, 1000};
        ::signal(SIGXFSZ, SIG_IGN);
        ::setrlimit(RLIMIT_FSIZE, &limit);
        try {
            replaceBy(folder / "f", std::string(5000, 'x'));
        } catch (const FileError& error) {
            return error.kind == FailureKind::CannotWrite ? 7 : 1;
        }
        return 2;
    });
    EXPECT_EQ(code, 7);
    EXPECT_EQ(rtcore::readTextFile(folder / "f"), "old");
    EXPECT_EQ(entries(folder.path()), 1U);
}

TEST(ReplaceFile, ThreadsThatReplaceOneFileEachWriteAllOfIt) {
    const test::TemporaryFolder folder;
    put(folder / "f", std::string(5000, 'a'));
    const auto replaceOften = [&](char letter) {
        for (int i = 0; i < 50; ++i) replaceBy(folder / "f", std::string(5000, letter));
    };
    std::thread one(replaceOften, 'a'), two(replaceOften, 'b');
    for (int i = 0; i < 200; ++i) {
        const std::string seen = rtcore::readTextFile(folder / "f");
        ASSERT_TRUE(seen == std::string(5000, 'a') || seen == std::string(5000, 'b')) << seen.size();
    }
    one.join();
    two.join();
    EXPECT_EQ(entries(folder.path()), 1U);
}

TEST(RemoveTemporaryFiles, HandlerOfASignalLeavesOnlyTheOldFile) {
    const test::TemporaryFolder folder;
    put(folder / "f", "old");
    const int code = inChild([&] {
        ::signal(SIGTERM, [](int) {
            rtcore::removeTemporaryFiles();
            ::_exit(143);
        });
        rtcore::replaceFile(folder / "f", [](const fs::path& temporary) {
            put(temporary, "half");
            ::raise(SIGTERM);
        });
        return 1;
    });
    EXPECT_EQ(code, 143);
    EXPECT_EQ(rtcore::readTextFile(folder / "f"), "old");
    EXPECT_EQ(entries(folder.path()), 1U);
}

TEST(RemoveTemporaryFiles, AForkedChildLeavesItsParentsFiles) {
    const test::TemporaryFolder folder;
    rtcore::replaceFile(folder / "f", [](const fs::path& temporary) {
        put(temporary, "whole");
        EXPECT_EQ(inChild([] {
                      rtcore::removeTemporaryFiles();
                      return 0;
                  }),
                  0);
    });
    EXPECT_EQ(rtcore::readTextFile(folder / "f"), "whole");
}

TEST(RemoveTemporaryFiles, TheTableServesAgainAfterwards) {
    const test::TemporaryFolder folder;
    for (int i = 0; i < 100; ++i) {
        const auto removeMidway = [](const fs::path& temporary) {
            rtcore::removeTemporaryFiles();
            EXPECT_FALSE(fs::exists(temporary));
        };
        ASSERT_EQ(errorOf([&] { rtcore::replaceFile(folder / "f", removeMidway); }).kind,
                  FailureKind::CannotWrite);
        replaceBy(folder / "f", "x");
    }
    EXPECT_EQ(entries(folder.path()), 1U);
}

TEST(ProgramFolder, HoldsThisProgram) {
    EXPECT_TRUE(fs::is_directory(rtcore::programFolder()));
    EXPECT_TRUE(fs::exists(rtcore::programFolder() / "test_platform"));
}
