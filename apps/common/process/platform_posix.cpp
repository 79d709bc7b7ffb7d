// Signals, streams and processes; background_posix.cpp has the rest of what the programs ask of the system.
#include "common/process/parent.h"
#include "common/process/process_watch.h"
#include "common/process/stop.h"
#include "common/process/terminal.h"
#include "common/process/threads.h"

#include "rtcore/platform/descriptor_posix.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/file_waits.h"
#include "rtcore/platform/files.h"
#include "rtcore/platform/processes.h"
#include "rtcore/settings/plain_text.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>

#include <fcntl.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <poll.h>
#include <sys/ioctl.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/resource.h>
#include <unistd.h>

namespace app {

namespace {

std::atomic<int> receivedSignal{0};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may touch it");

extern "C" void onStopSignal(int signal) {
    int none = 0;
    if (receivedSignal.compare_exchange_strong(none, signal)) return;
    rtcore::removeTemporaryFiles();
    _exit(128 + signal);
}

std::atomic<pid_t> parentProcess{0}; // 0: its end does not matter
// Apart from the signals: with one of these that comes later it does not make two.
std::atomic<bool> parentEnded{false};

bool orphaned() noexcept {
    const pid_t parent = parentProcess.load();
    return parent != 0 && getppid() != parent;
}

// The system means the thread that started this process; the others of the parent may live on.
extern "C" void onParentSignal(int) {
    const int error = errno;
    if (orphaned()) parentEnded = true;
    errno = error;
}

void handle(int signal, void (*handler)(int)) {
    struct sigaction current {};
    if (sigaction(signal, nullptr, &current) == 0 && current.sa_handler == SIG_IGN) return;
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
}

// Bytes that a stream which is ready takes without waiting: all that a pipe can hold when it is empty, so
// that a reader of the first lines only has got all of a short text.
std::size_t roomOf(int stream) noexcept {
#ifdef F_GETPIPE_SZ
    int held = 0;
    const int size = ::fcntl(stream, F_GETPIPE_SZ);
    if (size > PIPE_BUF && ::ioctl(stream, FIONREAD, &held) == 0 && held == 0)
        return static_cast<std::size_t>(size);
#else
    static_cast<void>(stream);
#endif
    return PIPE_BUF;
}

// A file must not get the number of a standard stream that the parent has closed: messages would go into it.
// Writing to what was closed still fails, as does reading.
void fillStandardStreams() noexcept {
    for (const auto& [stream, mode] : {std::pair(STDIN_FILENO, O_WRONLY), std::pair(STDOUT_FILENO, O_RDONLY),
                                       std::pair(STDERR_FILENO, O_RDONLY)}) {
        // It gets the lowest free number, which is this one.
        if (::fcntl(stream, F_GETFD) < 0) static_cast<void>(::open("/dev/null", mode));
    }
}

// Returns 0, or errno: EINTR when a signal asked to stop while the bytes are not taken.
int writeAll(int stream, std::string_view bytes) noexcept {
    constexpr int kLook = 20; // milliseconds
    while (!bytes.empty()) {
        pollfd room{stream, POLLOUT, 0};
        if (::poll(&room, 1, kLook) <= 0) {
            if (stopRequested()) return EINTR;
            continue;
        }
        const ssize_t written = ::write(stream, bytes.data(), std::min(bytes.size(), roomOf(stream)));
        if (written < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (written < 0) return errno;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
}

bool takesMore(int number) noexcept {
    pollfd stream{number, POLLOUT, 0};
    return ::poll(&stream, 1, 0) == 1 && (stream.revents & POLLOUT) != 0;
}

} // namespace

void installSignalHandlers() {
    fillStandardStreams();
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) handle(signal, onStopSignal);
    ignoreWritingSignals();
    rtcore::interruptFilesBy(stopRequested);
}

void ignoreWritingSignals() noexcept {
    for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);
}

void spinLittle([[maybe_unused]] char** argv) noexcept {
#if defined(_OPENMP) && defined(__linux__)
    constexpr const char* kSpins = "GOMP_SPINCOUNT"; // a few microseconds; as it is, more than a millisecond
    if (std::getenv(kSpins) != nullptr || std::getenv("OMP_WAIT_POLICY") != nullptr) return;
    char program[PATH_MAX];
    const ssize_t length = ::readlink("/proc/self/exe", program, sizeof program - 1);
    if (length <= 0 || ::setenv(kSpins, "1000", 1) != 0) return;
    program[length] = '\0';
    ::execv(program, argv);
#endif
}

void shareMemoryAmongThreads() noexcept {
#ifdef __GLIBC__
    mallopt(M_ARENA_MAX, 2);
#endif
}

void stopWithParent(std::int64_t parent) {
    parentProcess = parent == 0 ? getppid() : static_cast<pid_t>(parent);
#ifdef __linux__
    handle(SIGUSR2, onParentSignal);
    prctl(PR_SET_PDEATHSIG, SIGUSR2);
#endif
    // It may have ended before the system was asked to tell.
    if (orphaned()) parentEnded = true;
}

ProcessWatch::ProcessWatch(std::int64_t process) noexcept
    : process_(process), handle_(rtcore::openProcessHandle(static_cast<pid_t>(process)).release()) {}

ProcessWatch::~ProcessWatch() {
    if (handle_ >= 0) ::close(handle_);
}

ProcessWatch::ProcessWatch(ProcessWatch&& other) noexcept
    : process_(other.process_), handle_(std::exchange(other.handle_, -1)), ended_(other.ended_) {}

ProcessWatch& ProcessWatch::operator=(ProcessWatch&& other) noexcept {
    std::swap(process_, other.process_);
    std::swap(handle_, other.handle_);
    std::swap(ended_, other.ended_);
    return *this;
}

// Without a handle: an old system, or there was no such process.
bool ProcessWatch::ended() noexcept {
    if (ended_) return true;
    if (handle_ >= 0) {
        pollfd end{handle_, POLLIN, 0};
        ended_ = ::poll(&end, 1, 0) == 1;
    } else {
        ended_ = !rtcore::processRuns(process_);
    }
    return ended_;
}

int stopSignal() noexcept {
    // Not every system tells of a parent's end, and a parent may have left its children deaf to signals.
    if (!parentEnded && orphaned()) parentEnded = true;
    const int signal = receivedSignal.load();
    return signal == 0 && parentEnded ? SIGTERM : signal;
}

std::optional<int> terminalColumns() {
    if (isatty(STDERR_FILENO) == 0) return std::nullopt;
    winsize size{};
    const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return known ? std::max<int>(20, size.ws_col) : 80;
}

std::optional<std::string_view> readInput(std::span<char> bytes,
                                          std::chrono::milliseconds patience) noexcept {
    pollfd input{STDIN_FILENO, POLLIN, 0};
    if (::poll(&input, 1, static_cast<int>(patience.count())) <= 0) return std::string_view();
    const ssize_t got = ::read(STDIN_FILENO, bytes.data(), bytes.size());
    if (got < 0 && (errno == EINTR || errno == EAGAIN)) return std::string_view();
    if (got <= 0) return std::nullopt;
    return std::string_view(bytes.data(), static_cast<std::size_t>(got));
}

void writeOutput(std::string_view bytes) {
    const int error = writeAll(STDOUT_FILENO, bytes);
    if (error == EINTR) throw rtcore::FileError(rtcore::FailureKind::Stopped, "", "stopped");
    if (error != 0) {
        throw rtcore::FileError(rtcore::FailureKind::CannotWrite, "standard output", std::strerror(error));
    }
}

void writeLines(std::string_view lines) {
    if (isatty(STDOUT_FILENO) == 0) return writeOutput(lines);
    std::string shown;
    while (!lines.empty()) {
        const std::size_t end = std::min(lines.find_first_of("\t\n"), lines.size());
        shown += rtcore::printable(lines.substr(0, end));
        shown += lines.substr(end, 1);
        lines.remove_prefix(std::min(end + 1, lines.size()));
    }
    writeOutput(shown);
}

void writeError(std::string_view text) noexcept { writeAll(STDERR_FILENO, text); }

bool outputTakesMore() noexcept { return takesMore(STDOUT_FILENO); }
bool errorTakesMore() noexcept { return takesMore(STDERR_FILENO); }

std::uint64_t peakMemoryBytes() noexcept {
    rusage usage{};
    if (getrusage(RUSAGE_SELF, &usage) != 0) return 0;
#ifdef __APPLE__
    return static_cast<std::uint64_t>(usage.ru_maxrss);
#else
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
#endif
}

} // namespace app
