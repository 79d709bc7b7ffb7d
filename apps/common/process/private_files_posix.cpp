#include "common/process/private_files.h"

#include "rtcore/platform/error.h"

#include <fmt/core.h>

#include <fcntl.h>
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

constexpr mode_t kOthers = 077;

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
    constexpr std::size_t kMost = 4096;
    std::array<char, kMost> bytes{};
    const ssize_t count = ::read(file.number, bytes.data(), bytes.size());
    if (count < 0) throw FileError(FailureKind::NoInput, path, reason());
    return std::string(bytes.data(), static_cast<std::size_t>(count));
}

void writePrivateFile(const std::string& path, std::string_view text) {
    const OpenFile file(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
    const bool written = file.number >= 0 &&
                         ::write(file.number, text.data(), text.size()) == static_cast<ssize_t>(text.size());
    if (!written) throw FileError(FailureKind::CannotWrite, path, reason());
}

} // namespace app
