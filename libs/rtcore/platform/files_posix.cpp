#include "rtcore/platform/files.h"

#include "rtcore/platform/error.h"
#include "rtcore/platform/temporary_names.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <random>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace rtcore {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kSmallFile = std::size_t{64} << 10;
/// What a pipe or a device may deliver before it counts as endless.
constexpr std::size_t kStreamLimit = std::size_t{1} << 30;

std::string reason(int error) { return std::generic_category().message(error); }

[[noreturn]] void failReading(const fs::path& path, int error) {
    const char* advice = error == ENOENT || error == ENOTDIR ? "; check the spelling and the folder"
                         : error == EACCES                   ? "; check its permissions"
                         : error == EISDIR                   ? "; name a file in it"
                                                             : "";
    throw FileError(FailureKind::NoInput, path.string(), "cannot be read: " + reason(error) + advice);
}

[[noreturn]] void failWriting(const fs::path& path, int error) {
    const char* advice = error == ENOSPC || error == EDQUOT                    ? "; free some space there"
                         : error == ENOENT || error == ENOTDIR                 ? "; make its folder first"
                         : error == EACCES || error == EPERM || error == EROFS ? "; choose another folder"
                         : error == EISDIR                                     ? "; name a file in it"
                         : error == ENAMETOOLONG                               ? "; choose a shorter name"
                                                                               : "";
    throw FileError(FailureKind::CannotWrite, path.string(), "cannot be written: " + reason(error) + advice);
}

class Descriptor {
  public:
    explicit Descriptor(int fd) : fd_(fd) {}
    ~Descriptor() {
        if (fd_ >= 0) ::close(fd_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int get() const { return fd_; }
    bool valid() const { return fd_ >= 0; }
    /// Closes now; false, with errno set, when the system reports a late write error.
    bool close() { return ::close(std::exchange(fd_, -1)) == 0 || errno == EINTR; }

  private:
    int fd_;
};

int openRetrying(const fs::path& path, int flags, mode_t mode = 0) {
    int fd = -1;
    do fd = ::open(path.c_str(), flags | O_CLOEXEC, mode);
    while (fd < 0 && errno == EINTR);
    return fd;
}

struct Opened {
    Descriptor file;
    bool regular;
    std::size_t size; ///< as the system states it; 0 for what is no regular file
};

/// Until the pipe has something to read, or its writer has left; closes it when there is none.
void waitForWriter(const fs::path& path, int fd) {
    constexpr int kMilliseconds = 10'000;
    pollfd waiting{fd, POLLIN, 0};
    int ready = 0;
    do ready = ::poll(&waiting, 1, kMilliseconds);
    while (ready < 0 && errno == EINTR);
    if (ready == 0) {
        ::close(fd);
        throw FileError(FailureKind::NoInput, path.string(),
                        "it is a pipe, and nobody writes to it; give a file");
    }
}

Opened openForReading(const fs::path& path) {
    // Opening must not wait: a pipe that nobody writes to would hold the program for ever.
    const int fd = openRetrying(path, O_RDONLY | O_NONBLOCK);
    if (fd < 0) failReading(path, errno);
    struct stat status {};
    if (::fstat(fd, &status) != 0 || S_ISDIR(status.st_mode)) {
        const int error = S_ISDIR(status.st_mode) ? EISDIR : errno;
        ::close(fd);
        failReading(path, error);
    }
    if (S_ISFIFO(status.st_mode)) waitForWriter(path, fd);
    ::fcntl(fd, F_SETFL, ::fcntl(fd, F_GETFL) & ~O_NONBLOCK);
    const bool regular = S_ISREG(status.st_mode);
    return {Descriptor(fd), regular, regular ? static_cast<std::size_t>(status.st_size) : 0};
}

/// Reads on until the end, at most `limit` + 1 bytes, into a container of bytes.
template <typename Bytes>
void readToEnd(const fs::path& path, const Opened& opened, std::size_t limit, Bytes& bytes) {
    std::size_t filled = 0;
    bytes.resize(std::min(opened.size, limit) + 1);
    while (true) {
        const ssize_t got = ::read(opened.file.get(), bytes.data() + filled, bytes.size() - filled);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) failReading(path, errno);
        if (got == 0) break;
        filled += static_cast<std::size_t>(got);
        if (filled > limit) break;
        if (filled == bytes.size()) bytes.resize(std::min(limit + 1, std::max(filled * 2, kSmallFile)));
    }
    bytes.resize(filled);
    if (filled > limit) {
        throw FileError(FailureKind::BadData, path.string(),
                        "holds more than " + std::to_string(limit) +
                            " bytes; no file of this kind is so large");
    }
}

/// Null where the file cannot be mapped.
std::shared_ptr<const void> mapFile(const Opened& opened) {
    void* address = ::mmap(nullptr, opened.size, PROT_READ, MAP_PRIVATE, opened.file.get(), 0);
    if (address == MAP_FAILED) return nullptr;
    return {address, [size = opened.size](const void* p) { ::munmap(const_cast<void*>(p), size); }};
}

/// A name beside `target` that nobody has, with its extension (writers of pictures go by it).
fs::path freshName(const fs::path& target) {
    static constexpr std::string_view digits = "0123456789abcdef";
    thread_local std::random_device device;
    std::string name = ".rtsuite-";
    for (int word = 0; word < 2; ++word) {
        unsigned bits = device();
        for (int i = 0; i < 8; ++i, bits >>= 4U) name += digits[bits & 15U];
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

/// A file that is created here and removed again unless it has been renamed.
class SiblingFile {
  public:
    SiblingFile(const fs::path& shown, const fs::path& target)
        : path_(freshName(target)), name_(path_.string()) {
        // Mode 0666 less the umask, as any program's new file.
        const Descriptor created(openRetrying(path_, O_WRONLY | O_CREAT | O_EXCL, 0666));
        if (!created.valid()) failWriting(shown, errno);
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
    bool renamed_ = false;
};

void writePieces(const fs::path& shown, const fs::path& file,
                 std::span<const std::span<const std::byte>> pieces) {
    Descriptor opened(openRetrying(file, O_WRONLY | O_CREAT | O_TRUNC, 0666));
    if (!opened.valid()) failWriting(shown, errno);
    for (std::span<const std::byte> rest : pieces) {
        while (!rest.empty()) {
            const ssize_t put = ::write(opened.get(), rest.data(), rest.size());
            if (put < 0 && errno == EINTR) continue;
            if (put < 0) failWriting(shown, errno);
            rest = rest.subspan(static_cast<std::size_t>(put));
        }
    }
    if (!opened.close()) failWriting(shown, errno);
}

} // namespace

FileBytes openFileBytes(const fs::path& path) {
    const Opened opened = openForReading(path);
    if (opened.regular && opened.size >= kSmallFile) {
        if (auto mapping = mapFile(opened)) {
            const auto* first = static_cast<const std::byte*>(mapping.get());
            return {{first, opened.size}, std::move(mapping)};
        }
    }
    const auto bytes = std::make_shared<std::vector<std::byte>>();
    readToEnd(path, opened, std::max(opened.size, kStreamLimit), *bytes);
    return {*bytes, bytes};
}

std::string readTextFile(const fs::path& path, std::size_t limit) {
    std::string text;
    readToEnd(path, openForReading(path), limit, text);
    return text;
}

void replaceFile(const fs::path& path, const std::function<void(const fs::path&)>& write) {
    const fs::path target = followLinks(path);
    if (wantsDirectWriting(target)) {
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
