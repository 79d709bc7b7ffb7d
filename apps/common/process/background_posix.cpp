#include "common/process/background.h"

#include "common/process/stop.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <stdexcept>

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace app {

namespace {

int readyPipe = -1; ///< the child's end

ExitCode endOf(pid_t child) {
    int status = 0;
    while (::waitpid(child, &status, 0) < 0) {
        if (errno != EINTR) return ExitCode::Failed;
    }
    return WIFEXITED(status) ? static_cast<ExitCode>(WEXITSTATUS(status)) : ExitCode::Failed;
}

ExitCode waitFor(pid_t child, int pipe) {
    bool told = false;
    while (true) {
        constexpr int kMilliseconds = 50;
        pollfd stream{pipe, POLLIN, 0};
        const int ready = ::poll(&stream, 1, kMilliseconds);
        if (stopRequested() && !told) {
            ::kill(child, stopSignal());
            told = true;
        }
        if (ready <= 0) continue;
        char byte = 0;
        const bool detached = ::read(pipe, &byte, 1) == 1;
        return detached ? ExitCode::Done : endOf(child);
    }
}

} // namespace

std::optional<ExitCode> goToBackground() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe to the background process");
    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("no background process");
    if (child > 0) {
        ::close(ends[1]);
        return waitFor(child, ends[0]);
    }
    ::close(ends[0]);
    readyPipe = ends[1];
    startSession();
    return std::nullopt;
}

void detach() {
    const int nothing = ::open("/dev/null", O_RDWR | O_CLOEXEC);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (nothing >= 0) ::dup2(nothing, stream);
    }
    if (nothing > STDERR_FILENO) ::close(nothing);
    // A folder that is never unmounted. The paths of the command line are absolute.
    if (::chdir("/") != 0) errno = 0;
    const char byte = 1;
    while (::write(readyPipe, &byte, 1) < 0 && errno == EINTR) {
    }
    ::close(readyPipe);
    readyPipe = -1;
}

void startSession() noexcept { ::setsid(); }

namespace {

constexpr int kStep = 10;

bool keepsPriority() noexcept {
    const char* const keep = std::getenv("RT_KEEP_PRIORITY"); // NOLINT(concurrency-mt-unsafe)
    return keep != nullptr && *keep != '\0';
}

} // namespace

void lowerPriority() noexcept {
    if (!keepsPriority()) static_cast<void>(!::nice(kStep));
}

void lowerPriorityOf(std::int64_t process) noexcept {
    const auto id = static_cast<id_t>(process);
    if (!keepsPriority()) ::setpriority(PRIO_PROCESS, id, ::getpriority(PRIO_PROCESS, id) + kStep);
}

} // namespace app
