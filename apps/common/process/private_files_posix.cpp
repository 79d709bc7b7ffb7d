#include "common/process/private_files.h"

#include "rtcore/platform/error.h"
#include "rtcore/platform/sibling_file_posix.h"

#include <fmt/core.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <system_error>

namespace app {

namespace {

using rtcore::FailureKind;
using rtcore::FileError;

std::string reason() { return std::generic_category().message(errno); }

struct OpenFile {
    int number;
    explicit OpenFile(int file) : number(file) {}
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    ~OpenFile() {
        if (number >= 0) ::close(number);
    }
};

constexpr mode_t kOthers = 077, kPrivateFile = 0600, kPrivateFolder = 0700;

/// Takes the rights of others away from what is this user's.
bool isPrivate(const std::string& path, int flags, mode_t mode) {
    const OpenFile file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | flags));
    struct stat facts {};
    if (file.number < 0 || ::fstat(file.number, &facts) != 0 || facts.st_uid != ::getuid()) return false;
    return (facts.st_mode & kOthers) == 0 || ::fchmod(file.number, mode) == 0;
}

} // namespace

std::string privateRuntimeFolder(const std::string& name) {
    const char* const runtime = std::getenv("XDG_RUNTIME_DIR"); // NOLINT(concurrency-mt-unsafe)
    const bool given = runtime != nullptr && *runtime == '/';
    std::string folder =
        given ? fmt::format("{}/{}", runtime, name) : fmt::format("/tmp/{}-{}", name, ::getuid());
    ::mkdir(folder.c_str(), 0700);
    struct stat facts {};
    const bool ours = ::lstat(folder.c_str(), &facts) == 0 && S_ISDIR(facts.st_mode) &&
                      facts.st_uid == ::getuid() && (facts.st_mode & kOthers) == 0;
    if (!ours)
        throw FileError(FailureKind::CannotWrite, folder,
                        "this is no folder that only its owner can open; remove it, or set XDG_RUNTIME_DIR");
    return folder;
}

std::optional<std::string> readPrivateFile(const std::string& path) {
    const OpenFile file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (file.number < 0 && errno == ENOENT) return {};
    if (file.number < 0) throw FileError(FailureKind::NoInput, path, reason());
    struct stat facts {};
    if (::fstat(file.number, &facts) != 0 || !S_ISREG(facts.st_mode) || facts.st_uid != ::getuid() ||
        (facts.st_mode & kOthers) != 0)
        throw FileError(FailureKind::BadData, path, "other users may read it; 'chmod 600' it");
    constexpr std::size_t kMax = 4096;
    std::array<char, kMax> bytes{};
    const ssize_t count = ::read(file.number, bytes.data(), bytes.size());
    if (count < 0) throw FileError(FailureKind::NoInput, path, reason());
    if (count == 0) return {};
    return std::string(bytes.data(), static_cast<std::size_t>(count));
}

bool writePrivateFile(const std::string& path, std::string_view text) {
    rtcore::SiblingFile fresh(path, path, kPrivateFile);
    const OpenFile file(::open(fresh.path().c_str(), O_WRONLY | O_NOFOLLOW | O_CLOEXEC));
    const bool written =
        file.number >= 0 &&
        ::write(file.number, text.data(), text.size()) == static_cast<ssize_t>(text.size()) &&
        ::fsync(file.number) == 0;
    if (!written) rtcore::failWriting(path, errno);
    if (fresh.nameNew(path)) return true;
    // The process that has the lock of the empty file may take its place.
    const OpenFile empty(::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    if (empty.number < 0 || ::flock(empty.number, LOCK_EX | LOCK_NB) != 0) return false;
    struct stat opened {
    }, named{};
    const bool same = ::fstat(empty.number, &opened) == 0 && ::lstat(path.c_str(), &named) == 0 &&
                      opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
    if (!same || !S_ISREG(opened.st_mode) || opened.st_size != 0 || opened.st_uid != ::getuid()) return false;
    fresh.renameTo(path);
    return true;
}

bool makePrivateFolder(const std::string& path) noexcept {
    for (std::size_t end = path.find('/', 1); end != std::string::npos; end = path.find('/', end + 1))
        ::mkdir(path.substr(0, end).c_str(), kPrivateFolder);
    return ::mkdir(path.c_str(), kPrivateFolder) == 0 || isPrivate(path, O_DIRECTORY, kPrivateFolder);
}

bool makePrivateFile(const std::string& path) noexcept {
    const OpenFile made(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kPrivateFile));
    return made.number >= 0 || isPrivate(path, O_NOFOLLOW, kPrivateFile);
}

void keepOthersOut() noexcept { ::umask(kOthers); }

} // namespace app
