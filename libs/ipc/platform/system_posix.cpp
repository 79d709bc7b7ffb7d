#include "ipc/platform/system.h"

#include "ipc/platform/error.h"
#include "ipc/platform/rules.h"

#include <fmt/core.h>

#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstring>
#include <system_error>

#include <dirent.h>
#include <fcntl.h>
#include <linux/futex.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace ipc {

namespace {

constexpr const char* kSegmentFolder = "/dev/shm";

std::string reason(int code) { return std::error_code(code, std::generic_category()).message(); }

std::string megabytes(std::uint64_t bytes) {
    constexpr std::uint64_t kMega = 1000000;
    return bytes < kMega ? fmt::format("{} kB", (bytes + 999) / 1000)
                         : fmt::format("{} MB", (bytes + kMega - 1) / kMega);
}

[[noreturn]] void noSpace(std::size_t need, std::uint64_t rest) {
    throw Error(Problem::NoSpace,
                "shared memory: needs {0}, {1} has {2} left; free some (in a container: --shm-size) or ask "
                "for a lower resolution",
                {megabytes(need), kSegmentFolder, megabytes(rest)});
}

// No library's semaphore: damaged, it would end the process.
long futex(Doorbell& bell, int operation, const timespec* deadline) {
    static_assert(sizeof bell.rung == 4 && alignof(Doorbell) >= 4);
    return ::syscall(SYS_futex, &bell.rung, operation, operation == FUTEX_WAKE ? INT_MAX : 0, deadline,
                     nullptr, FUTEX_BITSET_MATCH_ANY);
}

// Locks belong to an open descriptor, not to a process: closing another descriptor drops nothing.
int lockCall(int segment, int operation, short type, std::uint64_t byte, struct flock* found = nullptr) {
    struct flock lock {};
    lock.l_type = type;
    lock.l_whence = SEEK_SET;
    lock.l_start = static_cast<off_t>(byte);
    lock.l_len = 1;
    const int result = ::fcntl(segment, operation, &lock);
    if (found != nullptr) *found = lock;
    return result;
}

} // namespace

std::uint32_t userId() { return ::geteuid(); }
std::int64_t processId() { return ::getpid(); }

int openSegment(const std::string& name, bool writing) {
    const std::string path = std::string(kSegmentFolder) + "/" + name;
    // Opening a foreign pipe would wait for its other end.
    const int patience = keeps("pipes are not waited for") ? O_NONBLOCK : 0;
    const int mode = patience | O_NOFOLLOW | O_CLOEXEC | (writing ? O_RDWR : O_RDONLY);
    const int segment = ::open(path.c_str(), mode);
    if (segment >= 0 || errno == ENOENT) return segment;
    const bool shortage = errno == EMFILE || errno == ENFILE || errno == ENOMEM || errno == EINTR;
    const std::string why = reason(errno);
    if (shortage) throw Error(Problem::System, "shared memory {0}: cannot be opened: {1}", {name, why});
    throw Error(Problem::NotYours,
                "shared memory {0}: cannot be opened: {1}; remove it or name another instance", {name, why});
}

void closeSegment(int segment) { ::close(segment); }

void renameSegment(const std::string& from, const std::string& to) {
    const std::string folder = std::string(kSegmentFolder) + "/";
    if (::rename((folder + from).c_str(), (folder + to).c_str()) == 0) return;
    throw Error(Problem::NotYours, "shared memory {0}: cannot be renamed: {1}", {from, reason(errno)});
}

bool tryLockByte(int segment, std::uint64_t byte) {
    if (lockCall(segment, F_OFD_SETLK, F_WRLCK, byte) == 0) return true;
    if (errno == EAGAIN || errno == EACCES) return false;
    throw Error(Problem::System, "shared memory cannot be locked: {0}", {reason(errno)});
}

void unlockByte(int segment, std::uint64_t byte) { lockCall(segment, F_OFD_SETLK, F_UNLCK, byte); }

bool isByteLocked(int segment, std::uint64_t byte) {
    struct flock found {};
    return lockCall(segment, F_OFD_GETLK, F_WRLCK, byte, &found) != 0 || found.l_type != F_UNLCK;
}

SegmentFacts factsOf(int segment) {
    struct stat facts {};
    if (::fstat(segment, &facts) != 0) return {};
    return {.regular = S_ISREG(facts.st_mode),
            .ours = facts.st_uid == ::geteuid() && (facts.st_mode & 077) == 0,
            .bytes = static_cast<std::uint64_t>(facts.st_size),
            .named = facts.st_nlink > 0};
}

void reserveSpace(int segment, std::size_t bytes, const std::string& name) {
    if (!keeps("space is reserved")) {
        if (::ftruncate(segment, static_cast<off_t>(bytes)) != 0) noSpace(bytes, 0);
        return;
    }
    struct statvfs volume {};
    const bool known = ::fstatvfs(segment, &volume) == 0;
    const std::uint64_t rest = known ? std::uint64_t{volume.f_bavail} * volume.f_frsize : 0;
    // A volume without a size, as tmpfs with size=0, reports no blocks at all.
    if (known && volume.f_blocks > 0 && rest < bytes) noSpace(bytes, rest);
    int code = 0;
    do {
        code = ::posix_fallocate(segment, 0, static_cast<off_t>(bytes));
    } while (code == EINTR);
    if (code == ENOSPC) noSpace(bytes, rest);
    if (code != 0) throw Error(Problem::System, "{0}: no memory for it: {1}", {name, reason(code)});
}

void requireSpace(std::size_t bytes) {
    struct statvfs volume {};
    if (::statvfs(kSegmentFolder, &volume) != 0 || volume.f_blocks == 0) return;
    const std::uint64_t rest = std::uint64_t{volume.f_bavail} * volume.f_frsize;
    if (rest < bytes) noSpace(bytes, rest);
}

std::vector<std::string> segmentNames(const std::string& prefix) {
    std::vector<std::string> names;
    DIR* folder = ::opendir(kSegmentFolder);
    if (folder == nullptr) return names;
    while (const dirent* entry = ::readdir(folder)) {
        struct stat facts {};
        if (std::strncmp(entry->d_name, prefix.c_str(), prefix.size()) == 0 &&
            ::fstatat(::dirfd(folder), entry->d_name, &facts, AT_SYMLINK_NOFOLLOW) == 0 &&
            facts.st_uid == ::geteuid()) {
            names.emplace_back(entry->d_name);
        }
    }
    ::closedir(folder);
    return names;
}

void ring(Doorbell& bell) {
    if (bell.rung.exchange(1, std::memory_order_acq_rel) == 0) futex(bell, FUTEX_WAKE, nullptr);
}

bool waitUntil(Doorbell& bell, Clock::time_point deadline) {
    const auto rung = [&] { return bell.rung.exchange(0, std::memory_order_acq_rel) != 0; };
    if (rung()) return true;
    const auto nanoseconds =
        std::chrono::duration_cast<std::chrono::nanoseconds>(deadline.time_since_epoch()).count();
    if (deadline <= Clock::now()) return false;
    timespec until{};
    until.tv_sec = static_cast<time_t>(nanoseconds / 1000000000);
    until.tv_nsec = static_cast<long>(nanoseconds % 1000000000);
    futex(bell, FUTEX_WAIT_BITSET, &until); // by the steady clock
    return rung();
}

} // namespace ipc
