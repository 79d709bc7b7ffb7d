#include "rtcore/platform/sibling_file_posix.h"

#include "rtcore/platform/error.h"
#include "rtcore/platform/file_rights_posix.h"
#include "rtcore/platform/sentence.h"

#include <algorithm>
#include <cerrno>
#include <random>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace rtcore {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kTemporaryPrefix = ".rtsuite-";
constexpr std::size_t kTemporaryDigits = 16;
constexpr std::string_view kHexDigits = "0123456789abcdef";

/// An unused name beside `target`, with its extension (writers of images go by it).
fs::path freshName(const fs::path& target) {
    thread_local std::random_device device;
    std::string name(kTemporaryPrefix);
    for (std::size_t word = 0; word < kTemporaryDigits / 8; ++word) {
        unsigned bits = device();
        for (int i = 0; i < 8; ++i, bits >>= 4U) name += kHexDigits[bits & 15U];
    }
    const std::string extension = target.extension().string();
    return target.parent_path() / (extension.size() <= 32 ? name + extension : name);
}

} // namespace

void failWriting(const fs::path& shown, int error) {
    const char* advice = error == ENOSPC || error == EDQUOT    ? form("{0}; free some space there")
                         : error == ENOENT || error == ENOTDIR ? form("{0}; make its folder first")
                         : error == EACCES || error == EPERM || error == EROFS
                             ? form("{0}; choose another folder")
                         : error == EISDIR       ? form("{0}; name a file in it")
                         : error == ENAMETOOLONG ? form("{0}; choose a shorter name")
                                                 : "{0}";
    throw FileError(FailureKind::CannotWrite, shown.string(),
                    say("cannot be written: {0}", say(advice, systemReason(error))));
}

SiblingFile::SiblingFile(fs::path shown, const fs::path& target, mode_t mode)
    : shown_(std::move(shown)), path_(freshName(target)), name_(path_.string()),
      lock_(openRetrying(path_, O_WRONLY | O_CREAT | O_EXCL, mode)) {
    if (!lock_.valid()) failWriting(shown_, errno);
    ::flock(lock_.get(), LOCK_EX | LOCK_NB);
}

SiblingFile::~SiblingFile() {
    if (!renamed_) ::unlink(path_.c_str());
}

void SiblingFile::complete(const fs::path& target) {
    // A writer may have put another file in the place of the one that was locked.
    const Descriptor written(openRetrying(path_, O_RDONLY | O_NOFOLLOW));
    if (!written.valid()) failWriting(shown_, errno);
    const auto rights = rightsOf(target);
    if (rights && !takeRights(written.get(), *rights)) failWriting(shown_, errno);
    // Some file systems know no flushing, and say so by these two.
    if (::fsync(written.get()) != 0 && errno != EINVAL && errno != ENOTSUP) failWriting(shown_, errno);
}

void SiblingFile::renameTo(const fs::path& target) {
    if (::rename(path_.c_str(), target.c_str()) != 0) failWriting(shown_, errno);
    renamed_ = true;
}

bool SiblingFile::nameNew(const fs::path& target) {
    if (::link(path_.c_str(), target.c_str()) == 0) return true;
    if (errno == EEXIST) return false;
    // Some file systems know no second names.
    if (errno != EPERM && errno != ENOTSUP && errno != EMLINK) failWriting(shown_, errno);
    struct stat there {};
    if (::lstat(target.c_str(), &there) == 0) return false;
    renameTo(target);
    return true;
}

bool isTemporaryName(std::string_view name) {
    if (!name.starts_with(kTemporaryPrefix)) return false;
    name.remove_prefix(kTemporaryPrefix.size());
    const std::size_t digits = std::min(name.find_first_not_of(kHexDigits), name.size());
    return digits == kTemporaryDigits && (name.size() == digits || name[digits] == '.');
}

} // namespace rtcore
