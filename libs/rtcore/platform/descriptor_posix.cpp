#include "rtcore/platform/descriptor_posix.h"

#include "rtcore/platform/error.h"
#include "rtcore/platform/file_waits.h"

#include <algorithm>
#include <atomic>

#include <fcntl.h>
#include <poll.h>
#ifdef __linux__
#include <sys/syscall.h>
#endif

namespace rtcore {

namespace {

constexpr int kSlice = 20; ///< milliseconds between two questions whether to stop

std::atomic<bool (*)() noexcept> stopQuestion{nullptr};
std::atomic<bool> onlyRegular{false};

void throwIfInterrupted() {
    const auto stopped = stopQuestion.load();
    if (stopped != nullptr && stopped()) throw FileError(FailureKind::Stopped, "", "stopped");
}

} // namespace

void interruptFilesBy(bool (*stopped)() noexcept) { stopQuestion = stopped; }

void allowRegularFilesOnly() { onlyRegular = true; }

bool regularFilesOnly() { return onlyRegular; }

int openRetrying(const std::filesystem::path& path, int flags, mode_t mode) {
    int fd = -1;
    do fd = ::open(path.c_str(), flags | O_CLOEXEC | O_NOCTTY, mode);
    while (fd < 0 && errno == EINTR);
    return fd;
}

bool waitUntilReady(int fd, short events, std::optional<int> milliseconds) {
    while (true) {
        const int slice = std::min(milliseconds.value_or(kSlice), kSlice);
        pollfd waiting{fd, events, 0};
        const int ready = ::poll(&waiting, 1, slice);
        if (ready > 0 || (ready < 0 && errno != EINTR)) return true;
        throwIfInterrupted();
        if (ready < 0 || !milliseconds) continue;
        *milliseconds -= slice;
        if (*milliseconds <= 0) return false;
    }
}

int openForWriting(const std::filesystem::path& path) {
    while (true) {
        const int fd = openRetrying(path, O_WRONLY | O_CREAT | O_TRUNC | O_NONBLOCK, 0666);
        // A pipe without a reader.
        if (fd >= 0 || errno != ENXIO) return fd;
        waitUntilReady(-1, 0, kSlice);
    }
}

ssize_t readWaiting(int fd, std::span<std::byte> bytes) {
    while (true) {
        const ssize_t got = ::read(fd, bytes.data(), bytes.size());
        if (got >= 0 || (errno != EINTR && errno != EAGAIN)) return got;
        waitUntilReady(fd, POLLIN);
    }
}

ssize_t writeWaiting(int fd, std::span<const std::byte> bytes) {
    while (true) {
        const ssize_t put = ::write(fd, bytes.data(), bytes.size());
        if (put >= 0 || (errno != EINTR && errno != EAGAIN)) return put;
        waitUntilReady(fd, POLLOUT);
    }
}

Descriptor openProcessHandle([[maybe_unused]] pid_t process) noexcept {
#ifdef SYS_pidfd_open
    return Descriptor(static_cast<int>(::syscall(SYS_pidfd_open, process, 0)));
#else
    return Descriptor();
#endif
}

} // namespace rtcore
