#include "rtcore/platform/append_file.h"

#include "rtcore/platform/error.h"
#include "rtcore/platform/output_links_posix.h"
#include "rtcore/platform/sentence.h"

#include <cerrno>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace rtcore {

namespace {

[[noreturn]] void fail(const std::filesystem::path& path, int error) {
    const char* advice = error == EEXIST ? form("{0}; choose another name, or remove it")
                         : error == ENOENT || error == ENOTDIR ? form("{0}; make its folder first")
                         : error == ENOSPC || error == EDQUOT  ? form("{0}; free some space there")
                                                               : "{0}";
    throw FileError(FailureKind::CannotWrite, path.string(),
                    say("cannot be written: {0}", say(advice, systemReason(error))));
}

} // namespace

AppendFile::AppendFile(const std::filesystem::path& path) : path_(path) {
    refuseForeignLinks(path);
    file_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0666);
    if (file_ < 0) fail(path_, errno);
}

AppendFile::~AppendFile() { ::close(file_); }

void AppendFile::append(std::string_view piece) {
    const auto before = size_;
    while (!piece.empty()) {
        const ssize_t put = ::write(file_, piece.data(), piece.size());
        if (put < 0 && errno == EINTR) continue;
        if (put < 0) {
            const int error = errno;
            // Where even this fails, a reader sees half a line, which it ignores.
            if (::ftruncate(file_, before) == 0) size_ = before;
            fail(path_, error);
        }
        size_ += put;
        piece.remove_prefix(static_cast<std::size_t>(put));
    }
}

void AppendFile::flush() {
    if (::fsync(file_) != 0 && errno != EINVAL && errno != ENOTSUP) fail(path_, errno);
}

} // namespace rtcore
