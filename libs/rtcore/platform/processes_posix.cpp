#include "rtcore/platform/processes.h"

#include "rtcore/platform/descriptor_posix.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"
#include "rtcore/platform/sentence.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace rtcore {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kWatchMilliseconds = 20;

struct Pipe {
    Descriptor read, write;
};

[[noreturn]] void failForWantOfDescriptors(const std::string& program) {
    throw FileError(FailureKind::TryAgain, program,
                    say("cannot be started: {0}; close some programs", systemReason(errno)));
}

Pipe makePipe(const std::string& program) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) failForWantOfDescriptors(program);
    ::fcntl(ends[0], F_SETFL, O_NONBLOCK);
    return {Descriptor(ends[0]), Descriptor(ends[1])};
}

/// For the input of a program: unlike a pipe, a socket can be written without SIGPIPE.
Pipe makeSocketPair(const std::string& program) {
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) failForWantOfDescriptors(program);
    return {Descriptor(ends[0]), Descriptor(ends[1])};
}

/// The steps that posix_spawn takes between fork and exec.
class SpawnPlan {
  public:
    /// `input` negative: the program gets none.
    SpawnPlan(int input, int output, int errors) {
        ::posix_spawn_file_actions_init(&actions_);
        if (input >= 0) {
            ::posix_spawn_file_actions_adddup2(&actions_, input, 0);
        } else {
            ::posix_spawn_file_actions_addopen(&actions_, 0, "/dev/null", O_RDONLY, 0);
        }
        ::posix_spawn_file_actions_adddup2(&actions_, output, 1);
        ::posix_spawn_file_actions_adddup2(&actions_, errors, 2);
#if defined(__GLIBC__) && __GLIBC_PREREQ(2, 34)
        ::posix_spawn_file_actions_addclosefrom_np(&actions_, 3);
#endif
        ::posix_spawnattr_init(&attributes_);
        sigset_t signals;
        ::sigemptyset(&signals);
        ::posix_spawnattr_setsigmask(&attributes_, &signals);
        ::sigfillset(&signals);
        ::posix_spawnattr_setsigdefault(&attributes_, &signals);
        ::posix_spawnattr_setpgroup(&attributes_, 0);
        ::posix_spawnattr_setflags(&attributes_,
                                   POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
    }
    ~SpawnPlan() {
        ::posix_spawn_file_actions_destroy(&actions_);
        ::posix_spawnattr_destroy(&attributes_);
    }
    SpawnPlan(const SpawnPlan&) = delete;
    SpawnPlan& operator=(const SpawnPlan&) = delete;

    pid_t start(const std::string& program, const std::vector<std::string>& arguments) const {
        std::vector<char*> words{const_cast<char*>(program.c_str())};
        for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
        words.push_back(nullptr);
        pid_t pid = 0;
        const int error =
            ::posix_spawn(&pid, program.c_str(), &actions_, &attributes_, words.data(), environ);
        if (error == 0) return pid;
        const bool shortage = error == EAGAIN || error == ENOMEM;
        throw FileError(shortage ? FailureKind::TryAgain : FailureKind::NoInput, program,
                        say("cannot be started: {0}", systemReason(error)));
    }

  private:
    posix_spawn_file_actions_t actions_{};
    posix_spawnattr_t attributes_{};
};

/// One output stream of the program: read as it comes, so that the program never blocks on it.
class Capture {
  public:
    Capture(Descriptor end, std::size_t kept) : end_(std::move(end)), kept_(kept) {}
    /// Reads what is there; true when there was something.
    bool drain() {
        bool any = false;
        std::array<char, 16384> chunk{};
        while (end_.valid()) {
            const ssize_t n = ::read(end_.get(), chunk.data(), chunk.size());
            if (n > 0) {
                any = true;
                text_.append(chunk.data(), std::min(static_cast<std::size_t>(n), kept_ - text_.size()));
            } else if (n == 0 || (errno != EAGAIN && errno != EINTR)) {
                end_.close();
            } else if (errno == EAGAIN) {
                break;
            }
        }
        return any;
    }
    int descriptor() const { return end_.get(); }
    std::string take() { return std::move(text_); }

  private:
    Descriptor end_;
    std::size_t kept_;
    std::string text_;
};

struct MemoryUse {
    std::uint64_t now = 0;  ///< bytes resident and swapped out
    std::uint64_t peak = 0; ///< most bytes ever resident
};

/// All zero when the process is gone.
MemoryUse memoryOf(pid_t pid) {
    std::ifstream status(fmt::format("/proc/{}/status", pid));
    MemoryUse use;
    for (std::string line; std::getline(status, line);) {
        const bool peak = line.starts_with("VmHWM:");
        if (!peak && !line.starts_with("VmRSS:") && !line.starts_with("VmSwap:")) continue;
        (peak ? use.peak : use.now) += std::strtoull(line.c_str() + line.find(':') + 1, nullptr, 10) * 1024;
    }
    return use;
}

bool hasEnded(pid_t pid) {
    siginfo_t info{};
    return ::waitid(P_PID, static_cast<id_t>(pid), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           info.si_pid == pid;
}

int waitForStatus(pid_t pid, rusage& usage) {
    int status = 0;
    while (::wait4(pid, &status, 0, &usage) < 0 && errno == EINTR) {
    }
    return status;
}

void setEnd(ProcessResult& result, int status) {
    const bool signalled = WIFSIGNALED(status);
    result.end = signalled ? ProcessEnd::Signalled : ProcessEnd::Exited;
    result.code = signalled ? WTERMSIG(status) : WEXITSTATUS(status);
}

/// Watches one running program until it is over. The process is reaped by `finish` alone, so that its number
/// cannot be given to another in between.
class Watch {
  public:
    Watch(pid_t pid, Capture output, Capture errors, const ProcessLimits& limits)
        : pid_(pid), handle_(openProcessHandle(pid)), output_(std::move(output)), errors_(std::move(errors)),
          limits_(limits) {}

    ProcessResult finish() {
        const Clock::time_point start = Clock::now();
        lastWord_ = lastLook_ = start;
        ProcessResult result;
        while (!hasEnded(pid_)) {
            if (const ProcessEnd broken = brokenLimit(); broken != ProcessEnd::Exited) {
                result.end = broken;
                break;
            }
            sleepUntilNews();
        }
        ::kill(-pid_, SIGKILL);
        reap(result);
        output_.drain();
        errors_.drain();
        result.output = output_.take();
        result.errors = errors_.take();
        result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
        return result;
    }

  private:
    void sleepUntilNews() {
        std::array<pollfd, 3> news{pollfd{handle_.get(), POLLIN, 0}, pollfd{output_.descriptor(), POLLIN, 0},
                                   pollfd{errors_.descriptor(), POLLIN, 0}};
        // Without a handle (Linux before 5.3) the end is noticed by looking.
        ::poll(news.data(), news.size(), handle_.valid() ? kWatchMilliseconds : 1);
        if (output_.drain()) lastWord_ = Clock::now();
        errors_.drain();
    }

    ProcessEnd brokenLimit() {
        const Clock::time_point now = Clock::now();
        if (limits_.stop != nullptr && limits_.stop->load()) return ProcessEnd::Stopped;
        if (limits_.silence > 0 && std::chrono::duration<double>(now - lastWord_).count() > limits_.silence) {
            return ProcessEnd::SilenceLimit;
        }
        if (now - lastLook_ < std::chrono::milliseconds(kWatchMilliseconds)) return ProcessEnd::Exited;
        lastLook_ = now;
        const MemoryUse use = memoryOf(pid_);
        peakMemory_ = std::max(peakMemory_, std::max(use.now, use.peak));
        if (limits_.memory > 0 && use.now > limits_.memory) return ProcessEnd::MemoryLimit;
        return ProcessEnd::Exited;
    }

    void reap(ProcessResult& result) const {
        rusage usage{};
        const int status = waitForStatus(pid_, usage);
        // The kernel counts both in batches: either may be behind the other.
        result.peakMemory = std::max(peakMemory_, static_cast<std::uint64_t>(usage.ru_maxrss) * 1024);
        if (result.end == ProcessEnd::Exited) setEnd(result, status);
    }

    pid_t pid_;
    Descriptor handle_;
    Capture output_, errors_;
    ProcessLimits limits_;
    Clock::time_point lastWord_, lastLook_;
    std::uint64_t peakMemory_ = 0;
};

void setLimit(__rlimit_resource resource, rlim_t value) {
    rlimit limit{};
    if (::getrlimit(resource, &limit) != 0) return;
    limit.rlim_cur = std::min(value, limit.rlim_max);
    ::setrlimit(resource, &limit);
}

} // namespace

ProcessResult runProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                         const ProcessLimits& limits) {
    Pipe output = makePipe(program.string());
    Pipe errors = makePipe(program.string());
    const pid_t pid =
        SpawnPlan(-1, output.write.get(), errors.write.get()).start(program.string(), arguments);
    output.write.close();
    errors.write.close();
    Watch watch(pid, Capture(std::move(output.read), limits.kept),
                Capture(std::move(errors.read), limits.kept), limits);
    return watch.finish();
}

struct PipedProcess::Parts {
    pid_t pid = -1; ///< -1 once it is reaped
    Descriptor input;
    Capture output, errors;
    std::function<bool()> stopped;

    void look(bool forRoom) {
        std::array<pollfd, 3> news{pollfd{forRoom ? input.get() : -1, POLLOUT, 0},
                                   pollfd{output.descriptor(), POLLIN, 0},
                                   pollfd{errors.descriptor(), POLLIN, 0}};
        ::poll(news.data(), news.size(), kWatchMilliseconds);
        output.drain();
        errors.drain();
        if (stopped && stopped()) throw FileError(FailureKind::Stopped, "", "stopped");
    }

    int reap() {
        ::kill(-pid, SIGKILL);
        rusage ignored{};
        return waitForStatus(std::exchange(pid, -1), ignored);
    }
};

PipedProcess::PipedProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                           std::function<bool()> stopped) {
    Pipe input = makeSocketPair(program.string());
    Pipe output = makePipe(program.string());
    Pipe errors = makePipe(program.string());
    const std::size_t kept = ProcessLimits{}.kept;
    parts_.reset(new Parts{.input = std::move(input.write),
                           .output = Capture(std::move(output.read), kept),
                           .errors = Capture(std::move(errors.read), kept),
                           .stopped = std::move(stopped)});
    parts_->pid = SpawnPlan(input.read.get(), output.write.get(), errors.write.get())
                      .start(program.string(), arguments);
}

PipedProcess::~PipedProcess() {
    if (parts_->pid > 0) parts_->reap();
}

bool PipedProcess::write(std::span<const std::byte> bytes) {
    Descriptor& input = parts_->input;
    while (!bytes.empty() && input.valid()) {
        parts_->look(true);
        const ssize_t put = ::send(input.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
        const bool full = put < 0 && (errno == EAGAIN || errno == EINTR);
        if (put >= 0) bytes = bytes.subspan(static_cast<std::size_t>(put));
        // A child of the program may hold its input open after the program has ended.
        if ((put < 0 && !full) || (full && hasEnded(parts_->pid))) input.close();
    }
    return bytes.empty();
}

ProcessResult PipedProcess::finish() {
    parts_->input.close();
    while (!hasEnded(parts_->pid)) parts_->look(false);
    ProcessResult result;
    setEnd(result, parts_->reap());
    parts_->output.drain();
    parts_->errors.drain();
    result.output = parts_->output.take();
    result.errors = parts_->errors.take();
    return result;
}

namespace {

/// Between fork and exec: only calls that are safe there.
[[noreturn]] void becomeAttached(const std::filesystem::path& program, char* const* words, pid_t parent,
                                 int report) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(1);
    // Those that are handled become default by exec; those that our parent ignores (nohup) stay so.
    for (const int signal : {SIGPIPE, SIGXFSZ}) ::signal(signal, SIG_DFL);
    ::execv(program.c_str(), words);
    const int error = errno;
    [[maybe_unused]] const ssize_t told = ::write(report, &error, sizeof error);
    ::_exit(127);
}

/// Waits until the child is the program.
pid_t startAttached(const std::filesystem::path& program, const std::vector<std::string>& arguments) {
    std::vector<char*> words{const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) failForWantOfDescriptors(program.string());
    const Descriptor read(ends[0]);
    Descriptor write(ends[1]);
    const pid_t parent = ::getpid();
    const pid_t pid = ::fork();
    if (pid < 0) failForWantOfDescriptors(program.string());
    if (pid == 0) becomeAttached(program, words.data(), parent, write.get());
    write.close();
    int error = 0;
    ssize_t got = 0;
    do got = ::read(read.get(), &error, sizeof error);
    while (got < 0 && errno == EINTR);
    if (got != sizeof error) return pid;
    rusage ignored{};
    waitForStatus(pid, ignored);
    throw FileError(error == ENOMEM ? FailureKind::TryAgain : FailureKind::NoInput, program.string(),
                    say("cannot be started: {0}", systemReason(error)));
}

} // namespace

ProcessResult runForeground(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                            const std::function<int()>& stopSignal) {
    using namespace std::chrono_literals;
    const pid_t pid = startAttached(program, arguments);
    const Descriptor handle = openProcessHandle(pid);
    Clock::time_point asked{};
    bool sent = false;
    while (!hasEnded(pid)) {
        pollfd news{handle.get(), POLLIN, 0};
        ::poll(&news, 1, kWatchMilliseconds);
        const int signal = stopSignal ? stopSignal() : 0;
        if (signal == 0) continue;
        if (asked == Clock::time_point{}) asked = Clock::now();
        // Ctrl-C reaches the whole group: a second signal would make the program end at once.
        if (!sent && Clock::now() - asked > 250ms) sent = ::kill(pid, signal) == 0;
        if (Clock::now() - asked > 10s) ::kill(pid, SIGKILL);
    }
    rusage ignored{};
    ProcessResult result;
    setEnd(result, waitForStatus(pid, ignored));
    return result;
}

std::optional<std::filesystem::path> findProgram(const std::string& name) {
    const char* const folders = std::getenv("PATH");
    std::istringstream list(folders != nullptr ? folders : "");
    for (std::string folder; std::getline(list, folder, ':');) {
        std::error_code ignored;
        const std::filesystem::path program = std::filesystem::path(folder) / name;
        if (!folder.empty() && std::filesystem::is_regular_file(program, ignored) &&
            ::access(program.c_str(), X_OK) == 0) {
            return program;
        }
    }
    return std::nullopt;
}

std::filesystem::path helperProgram(const std::string& name) {
    std::error_code unknown;
    const std::filesystem::path beside = programFolder() / name;
    const std::filesystem::path apart = programFolder().parent_path() / "libexec" / "rtsuite" / name;
    return !std::filesystem::exists(beside, unknown) && std::filesystem::exists(apart, unknown) ? apart
                                                                                                : beside;
}

void dieWithParent(std::int64_t parent) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    // The parent may have died before the line above.
    if (::getppid() != parent) std::_Exit(1);
}

void limitAddressSpace([[maybe_unused]] std::uint64_t bytes) {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    setLimit(RLIMIT_AS, bytes);
#endif
}

void disableCoreDumps() { setLimit(RLIMIT_CORE, 0); }

std::uint64_t machineMemory() {
    const long pages = ::sysconf(_SC_PHYS_PAGES), bytes = ::sysconf(_SC_PAGESIZE);
    if (pages <= 0 || bytes <= 0) return ~std::uint64_t{0};
    return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(bytes);
}

std::int64_t processId() { return ::getpid(); }

bool processRuns(std::int64_t process) {
    return ::kill(static_cast<pid_t>(process), 0) == 0 || errno == EPERM;
}

std::string signalName(int signal) {
    const char* const name = ::strsignal(signal);
    return name != nullptr ? name : fmt::format("signal {}", signal);
}

} // namespace rtcore
