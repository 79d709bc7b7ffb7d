#include "rtcore/platform/backups.h"

#include "rtcore/platform/error.h"
#include "rtcore/platform/file_rights_posix.h"
#include "rtcore/platform/files.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/platform/sibling_file_posix.h"

#include <cerrno>
#include <span>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace rtcore {

namespace fs = std::filesystem;

namespace {

/// False: the name is taken.
bool copyAs(const fs::path& source, const fs::path& target) {
    const FileBytes old = openFileBytes(source);
    SiblingFile copy(target, target, 0600);
    const Descriptor file(openRetrying(copy.path(), O_WRONLY | O_NOFOLLOW));
    if (!file.valid()) failWriting(target, errno);
    for (std::span<const std::byte> rest = old.bytes; !rest.empty();) {
        const ssize_t put = writeWaiting(file.get(), rest);
        if (put < 0) failWriting(target, errno);
        rest = rest.subspan(static_cast<std::size_t>(put));
    }
    copy.complete(source);
    return copy.nameNew(target);
}

/// The same.
bool keepAs(const fs::path& path, const fs::path& backup) {
    std::error_code none;
    if (fs::exists(fs::symlink_status(backup, none))) return false;
    if (::linkat(AT_FDCWD, path.c_str(), AT_FDCWD, backup.c_str(), AT_SYMLINK_FOLLOW) == 0) return true;
    if (errno == EEXIST) return false;
    // Another file system behind a link, one without links, or a file of another user (protected_hardlinks).
    if (errno != EXDEV && errno != EPERM && errno != ENOTSUP && errno != EMLINK) failWriting(backup, errno);
    return copyAs(path, backup);
}

} // namespace

fs::path keepBackup(const fs::path& path) {
    for (int number = 1; number <= kMaxBackups; ++number) {
        const fs::path backup = path.string() + '~' + (number == 1 ? "" : std::to_string(number));
        if (keepAs(path, backup)) return backup;
    }
    throw FileError(FailureKind::CannotWrite, path.string(),
                    say("{0} old versions of it are kept, {1}~ and so on; remove those that you do not need",
                        kMaxBackups, path.filename().string()));
}

} // namespace rtcore
