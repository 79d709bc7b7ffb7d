#include "rtcore/platform/files.h"

#include "rtcore/platform/descriptor_posix.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/temporary_names.h"

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <random>
#include <string_view>
#include <system_error>

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

std::string reason(int error) { return std::generic_category().message(error); }

[[noreturn]] void failWriting(const fs::path& path, int error) {
    const char* advice = error == ENOSPC || error == EDQUOT                    ? "; free some space there"
                         : error == ENOENT || error == ENOTDIR                 ? "; make its folder first"
                         : error == EACCES || error == EPERM || error == EROFS ? "; choose another folder"
                         : error == EISDIR                                     ? "; name a file in it"
                         : error == ENAMETOOLONG                               ? "; choose a shorter name"
                                                                               : "";
    throw FileError(FailureKind::CannotWrite, path.string(), "cannot be written: " + reason(error) + advice);
}

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

/// Where a chain of symbolic links ends; the end need not exist. Throws when the chain is a circle.
fs::path followLinks(fs::path path) {
    for (int i = 0; i < 40; ++i) {
        std::error_code error;
        const fs::path next = fs::read_symlink(path, error);
        if (error) return path;
        path = path.parent_path() / next;
        // Links of /proc/self/fd name files that are open: only they can be written, the names lead
        // elsewhere.
        if (path.string().starts_with("/proc/")) return path;
    }
    failWriting(path, ELOOP);
}

/// What replacing would destroy or miss: devices, pipes, and the files behind /dev/stdout.
bool wantsDirectWriting(const fs::path& path) {
    const std::string name = path.string();
    if (name.starts_with("/proc/") || name.starts_with("/dev/fd/")) return true;
    struct stat status {};
    return ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

void flushFile(const fs::path& shown, const fs::path& file) {
    const Descriptor opened(openRetrying(file, O_RDONLY));
    if (!opened.valid()) failWriting(shown, errno);
    // Some file systems know no flushing, and say so by these two.
    if (::fsync(opened.get()) != 0 && errno != EINVAL && errno != ENOTSUP) failWriting(shown, errno);
}

/// Makes the rename last through a power failure. The new content stands already: a failure here changes
/// nothing.
void flushFolder(const fs::path& file) {
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    const Descriptor opened(openRetrying(folder, O_RDONLY | O_DIRECTORY));
    if (opened.valid()) ::fsync(opened.get());
}

/// A file that is created here and removed again unless it has been renamed. Its lock tells other processes
/// that it is still being written.
class SiblingFile {
  public:
    SiblingFile(const fs::path& shown, const fs::path& target)
        : path_(freshName(target)), name_(path_.string()),
          // Mode 0666 less the umask, as any program's new file.
          lock_(openRetrying(path_, O_WRONLY | O_CREAT | O_EXCL, 0666)) {
        if (!lock_.valid()) failWriting(shown, errno);
        ::flock(lock_.get(), LOCK_EX | LOCK_NB);
    }
    ~SiblingFile() {
        if (!renamed_) ::unlink(path_.c_str());
    }
    SiblingFile(const SiblingFile&) = delete;
    SiblingFile& operator=(const SiblingFile&) = delete;
    const fs::path& path() const { return path_; }
    void renameTo(const fs::path& shown, const fs::path& target) {
        if (::rename(path_.c_str(), target.c_str()) != 0) failWriting(shown, errno);
        renamed_ = true;
    }

  private:
    fs::path path_;
    TemporaryName name_;
    Descriptor lock_;
    bool renamed_ = false;
};

/// Whether freshName() makes such names.
bool isTemporaryName(std::string_view name) {
    if (!name.starts_with(kTemporaryPrefix)) return false;
    name.remove_prefix(kTemporaryPrefix.size());
    const std::size_t digits = std::min(name.find_first_not_of(kHexDigits), name.size());
    return digits == kTemporaryDigits && (name.size() == digits || name[digits] == '.');
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
    SiblingFile temporary(path, target);
    write(temporary.path());
    flushFile(path, temporary.path());
    temporary.renameTo(path, target);
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

TemporaryFile::TemporaryFile(const std::string& prefix) {
    std::error_code error;
    const fs::path folder = fs::temp_directory_path(error);
    if (error) failWriting("folder for temporary files", error.value());
    std::string name = (folder / (prefix + "XXXXXX")).string();
    const Descriptor created(::mkostemp(name.data(), O_CLOEXEC));
    if (!created.valid()) failWriting(name, errno);
    path_ = name;
}

TemporaryFile::~TemporaryFile() { ::unlink(path_.c_str()); }

fs::path programFolder() {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    return error ? fs::current_path() : program.parent_path();
}

} // namespace rtcore
