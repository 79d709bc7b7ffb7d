#include "ipc/platform/system.h"

#include "ipc/platform/error.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <new>
#include <system_error>

#include <dirent.h>
#include <fcntl.h>
#include <semaphore.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

namespace ipc {

namespace {

constexpr const char* kSegmentFolder = "/dev/shm";

std::string reason(int code) { return std::error_code(code, std::generic_category()).message(); }

class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int number() const { return number_; }

  private:
    int number_;
};

void makePrivateFolder(const std::string& path) {
    if (::mkdir(path.c_str(), 0700) != 0 && errno != EEXIST) {
        throw Error(Problem::System, path + ": cannot be made: " + reason(errno));
    }
    struct stat facts {};
    if (::lstat(path.c_str(), &facts) != 0 || !S_ISDIR(facts.st_mode) || facts.st_uid != ::geteuid() ||
        (facts.st_mode & 077) != 0) {
        throw Error(Problem::NotYours,
                    path + ": is not a folder of yours alone; remove it or correct its mode to 0700");
    }
}

// The runtime folder is believed only when it is ours: after `su` the variable may name another user's.
bool usableRuntimeFolder(const char* path) {
    struct stat facts {};
    return path != nullptr && path[0] == '/' && ::stat(path, &facts) == 0 && S_ISDIR(facts.st_mode) &&
           facts.st_uid == ::geteuid() && ::access(path, W_OK | X_OK) == 0;
}

std::string megabytes(std::uint64_t bytes) {
    constexpr std::uint64_t kMega = 1000000;
    return bytes < kMega ? std::to_string((bytes + 999) / 1000) + " kB"
                         : std::to_string((bytes + kMega - 1) / kMega) + " MB";
}

[[noreturn]] void noSpace(std::size_t need, std::uint64_t rest) {
    throw Error(Problem::NoSpace,
                "shared memory: needs " + megabytes(need) + ", " + kSegmentFolder + " has " +
                    megabytes(rest) +
                    " left; free some (in a container: --shm-size) or ask for a lower resolution");
}

sem_t* semaphore(Doorbell& bell) { return std::launder(reinterpret_cast<sem_t*>(bell.memory)); }
static_assert(sizeof(sem_t) <= sizeof(Doorbell) && alignof(sem_t) <= alignof(Doorbell));

// Boost's semaphore is this one, but it waits by the wall clock, and a step of that stretches the wait.
int timedWait(sem_t* bell, const timespec& deadline) {
#if defined(__GLIBC__) && __GLIBC_PREREQ(2, 30)
    return ::sem_clockwait(bell, CLOCK_MONOTONIC, &deadline);
#else
    timespec now{}, wall{};
    ::clock_gettime(CLOCK_MONOTONIC, &now);
    ::clock_gettime(CLOCK_REALTIME, &wall);
    constexpr long kSecond = 1000000000;
    const long nanoseconds = deadline.tv_nsec - now.tv_nsec + wall.tv_nsec;
    wall.tv_sec += deadline.tv_sec - now.tv_sec + nanoseconds / kSecond - (nanoseconds < 0 ? 1 : 0);
    wall.tv_nsec = (nanoseconds % kSecond + kSecond) % kSecond;
    return ::sem_timedwait(bell, &wall);
#endif
}

// Bounded, for a counter that somebody scribbled on.
bool drain(sem_t* bell) {
    bool rung = false;
    for (int i = 0; i < 1024 && ::sem_trywait(bell) == 0; ++i) rung = true;
    return rung;
}

} // namespace

std::uint32_t userId() { return ::geteuid(); }
std::int64_t processId() { return ::getpid(); }

std::string lockFolder() {
    const char* runtime = std::getenv("XDG_RUNTIME_DIR");
    std::string folder = std::string(runtime == nullptr ? "" : runtime) + "/rts";
    if (!usableRuntimeFolder(runtime)) {
        folder = (std::filesystem::temp_directory_path() / ("rts-" + std::to_string(userId()))).string();
    }
    makePrivateFolder(folder);
    return folder;
}

void createPrivateFile(const std::string& path) {
    const Descriptor file(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600));
    if (file.number() < 0) throw Error(Problem::System, path + ": cannot be opened: " + reason(errno));
}

FileIdentity identityOf(const std::string& path) {
    struct stat facts {};
    if (::stat(path.c_str(), &facts) != 0) return {};
    return {facts.st_dev, facts.st_ino};
}

LockHolder foreignLockHolder(const std::string& path) {
    const Descriptor file(::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW));
    if (file.number() < 0) return {};
    struct flock lock {};
    lock.l_type = F_WRLCK;
    lock.l_whence = SEEK_SET;
    if (::fcntl(file.number(), F_GETLK, &lock) != 0 || lock.l_type == F_UNLCK) return {};
    return {true, std::max<std::int64_t>(0, lock.l_pid)};
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
    if (code != 0) throw Error(Problem::System, name + ": no memory for it: " + reason(code));
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
        if (std::strncmp(entry->d_name, prefix.c_str(), prefix.size()) == 0)
            names.emplace_back(entry->d_name);
    }
    ::closedir(folder);
    return names;
}

void initialise(Doorbell& bell) {
    if (::sem_init(new (bell.memory) sem_t, 1, 0) != 0) {
        throw Error(Problem::System, "no semaphore between processes: " + reason(errno));
    }
}

void ring(Doorbell& bell) { ::sem_post(semaphore(bell)); } // fails only when it was rung two billion times

bool waitUntil(Doorbell& bell, Clock::time_point deadline) {
    if (drain(semaphore(bell))) return true;
    const auto nanoseconds =
        std::chrono::duration_cast<std::chrono::nanoseconds>(deadline.time_since_epoch()).count();
    if (deadline <= Clock::now()) return false;
    timespec until{};
    until.tv_sec = static_cast<time_t>(nanoseconds / 1000000000);
    until.tv_nsec = static_cast<long>(nanoseconds % 1000000000);
    if (timedWait(semaphore(bell), until) != 0) return false;
    drain(semaphore(bell));
    return true;
}

} // namespace ipc
