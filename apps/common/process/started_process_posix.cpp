#include "common/process/started_process.h"

#include "common/process/background.h"

#include "rtcore/platform/error.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <system_error>
#include <thread>
#include <utility>

namespace app {

namespace {

/// For the input of a program: unlike a pipe, a socket can be written without SIGPIPE, and without waiting.
struct Ends {
    int own = -1, program = -1;
};

Ends makeInput(const std::string& program) {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) == 0) return {ends[0], ends[1]};
    throw rtcore::FileError(rtcore::FailureKind::TryAgain, program, std::generic_category().message(errno));
}

pid_t spawn(std::vector<std::string> words, int input) {
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t actions{};
    ::posix_spawn_file_actions_init(&actions);
    if (input >= 0) {
        ::posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
        ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    }
    pid_t process = 0;
    const int error =
        ::posix_spawn(&process, words.front().c_str(), &actions, nullptr, pointers.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    if (error == 0) return process;
    const bool shortage = error == EAGAIN || error == ENOMEM;
    throw rtcore::FileError(shortage ? rtcore::FailureKind::TryAgain : rtcore::FailureKind::NoInput,
                            words.front(), std::generic_category().message(error));
}

} // namespace

StartedProcess::StartedProcess(const std::filesystem::path& program,
                               const std::vector<std::string>& arguments, Role role) {
    std::vector<std::string> words{program.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    if (role == Role::Beside) {
        process_ = spawn(std::move(words), -1);
        return;
    }
    const Ends ends = makeInput(words.front());
    try {
        process_ = spawn(std::move(words), ends.program);
    } catch (...) {
        ::close(ends.own);
        ::close(ends.program);
        throw;
    }
    ::close(ends.program);
    input_ = ends.own;
    lowerPriorityOf(process_);
}

StartedProcess::~StartedProcess() {
    using namespace std::chrono_literals;
    askToStop();
    for (auto left = 3000ms; left > 0ms && !ended(); left -= 10ms) std::this_thread::sleep_for(10ms);
    if (input_ >= 0) ::close(input_);
}

void StartedProcess::askToStop() noexcept {
    if (!ended()) ::kill(static_cast<pid_t>(process_), SIGTERM);
}

bool StartedProcess::write(std::string_view text) noexcept {
    if (input_ < 0) return false;
    return ::send(input_, text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT) ==
           static_cast<ssize_t>(text.size());
}

std::optional<int> StartedProcess::ended() noexcept {
    int status = 0;
    const auto process = static_cast<pid_t>(process_);
    if (!code_ && ::waitpid(process, &status, WNOHANG) == process)
        code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 1;
    return code_;
}

} // namespace app
