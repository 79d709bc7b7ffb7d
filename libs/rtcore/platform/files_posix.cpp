#include "rtcore/platform/files.h"

#include "rtcore/platform/descriptor_posix.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/file_rights_posix.h"
#include "rtcore/platform/output_links_posix.h"
#include "rtcore/platform/sibling_file_posix.h"

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace rtcore {

namespace fs = std::filesystem;

namespace {

/// Whether replacing would destroy or miss it: devices, pipes, and the files behind /dev/stdout.
bool wantsDirectWriting(const fs::path& path) {
    const std::string name = path.string();
    if (name.starts_with("/proc/") || name.starts_with("/dev/fd/")) return true;
    struct stat status {};
    return ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

/// Makes the rename last through a power failure. The new content stands already: a failure here changes
/// nothing.
void flushFolder(const fs::path& file) {
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    const Descriptor opened(openRetrying(folder, O_RDONLY | O_DIRECTORY));
    if (opened.valid()) ::fsync(opened.get());
}

/// A file of this user that has not been written for so long and whose lock is free. On a file system without
/// locks none is free, so that no file counts as forgotten there. time() may lag behind the clock of files,
/// so that a file just written seems to come from the future: its age is 0.
bool isForgotten(const fs::path& path, std::int64_t seconds) {
    struct stat status {};
    if (::lstat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return false;
    const bool ours = status.st_uid == ::geteuid() && status.st_nlink == 1;
    const std::int64_t written = std::max(status.st_mtime, status.st_ctime);
    if (!ours || std::max<std::int64_t>(std::time(nullptr) - written, 0) < seconds) return false;
    const Descriptor file(openRetrying(path, O_RDONLY | O_NONBLOCK | O_NOFOLLOW));
    return file.valid() && ::flock(file.get(), LOCK_EX | LOCK_NB) == 0;
}

void writePieces(const fs::path& shown, const fs::path& file,
                 std::span<const std::span<const std::byte>> pieces) {
    Descriptor opened(openForWriting(file));
    if (!opened.valid()) failWriting(shown, errno);
    for (std::span<const std::byte> rest : pieces) {
        while (!rest.empty()) {
            const ssize_t put = writeWaiting(opened.get(), rest);
            if (put < 0) failWriting(shown, errno);
            rest = rest.subspan(static_cast<std::size_t>(put));
        }
    }
    if (!opened.close()) failWriting(shown, errno);
}

} // namespace

void replaceFile(const fs::path& path, const std::function<void(const fs::path&)>& write) {
    const fs::path target = followLinks(path);
    if (wantsDirectWriting(target)) {
        if (regularFilesOnly())
            throw FileError(FailureKind::CannotWrite, path.string(), "it is no regular file; name another");
        write(target);
        return;
    }
    std::error_code ignored;
    if (fs::is_directory(target, ignored)) failWriting(path, EISDIR);
    // No other user sees anything of a new file before it has the rights of the one that it replaces.
    const mode_t mode = rightsOf(target) ? 0600 : 0666;
    SiblingFile temporary(path, target, mode);
    write(temporary.path());
    temporary.complete(target);
    temporary.renameTo(target);
    flushFolder(target);
}

void writeFileAtomically(const fs::path& path, std::span<const std::span<const std::byte>> pieces) {
    replaceFile(path, [&](const fs::path& temporary) { writePieces(path, temporary, pieces); });
}

void removeForgottenFiles(const fs::path& folder, std::int64_t seconds) {
    std::error_code error;
    const fs::path place = folder.empty() ? fs::path(".") : folder;
    for (fs::directory_iterator entry(place, error), end; !error && entry != end; entry.increment(error)) {
        const fs::path& path = entry->path();
        if (isTemporaryName(path.filename().string()) && isForgotten(path, seconds)) ::unlink(path.c_str());
    }
}

std::optional<FileIdentity> identityOf(const fs::path& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return std::nullopt;
    return FileIdentity{status.st_dev, status.st_ino};
}

fs::path programFolder() {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    return error ? fs::current_path() : program.parent_path();
}

} // namespace rtcore
