/// Open files, for POSIX sources that call the system (here and in apps/common/process): descriptors that
/// close themselves and never wait unheard.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <utility>

#include <cerrno>
#include <sys/types.h>
#include <unistd.h>

namespace rtcore {

class Descriptor {
  public:
    explicit Descriptor(int fd = -1) : fd_(fd) {}
    ~Descriptor() {
        if (fd_ >= 0) ::close(fd_);
    }
    Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(fd_, other.fd_);
        return *this;
    }
    /// The caller closes it from now on.
    int release() { return std::exchange(fd_, -1); }
    int get() const { return fd_; }
    bool valid() const { return fd_ >= 0; }
    /// Closes now, unless that is done; false, with errno set, when the system reports a late write error.
    bool close() { return !valid() || ::close(release()) == 0 || errno == EINTR; }

  private:
    int fd_;
};

/// Like open(2), closed in programs that are started; an interruption is no failure.
int openRetrying(const std::filesystem::path& path, int flags, mode_t mode = 0);

/// Whether allowRegularFilesOnly() was called.
bool regularFilesOnly();

/// Waits until one of the `events` of poll(2) is there, or what stands for an end. False after so many
/// milliseconds; nothing = no limit. Throws FileError Stopped once the function of interruptFilesBy() says
/// so.
bool waitUntilReady(int fd, short events, std::optional<int> milliseconds = std::nullopt);

/// Opens a pipe or a device for writing and waits for its reader. Returns what open(2) does, errors in errno.
/// Throws as waitUntilReady() does.
int openForWriting(const std::filesystem::path& path);

/// Like read(2) and write(2) for descriptors that do not block: they wait as waitUntilReady() does.
ssize_t readWaiting(int fd, std::span<std::byte> bytes);
ssize_t writeWaiting(int fd, std::span<const std::byte> bytes);

/// Ready to be read (poll(2)) once that process has ended; a zombie has. Not valid when there is no such
/// process, or the system has no such handle (Linux before 5.3).
Descriptor openProcessHandle(pid_t process) noexcept;

} // namespace rtcore
