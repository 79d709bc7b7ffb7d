#include "common/process/started_process.h"

#include "rtcore/platform/error.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <system_error>
#include <thread>

namespace app {

StartedProcess::StartedProcess(const std::filesystem::path& program,
                               const std::vector<std::string>& arguments) {
    std::vector<std::string> words{program.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    pid_t process = 0;
    const int error =
        ::posix_spawn(&process, words.front().c_str(), nullptr, nullptr, pointers.data(), environ);
    if (error != 0)
        throw rtcore::FileError(rtcore::FailureKind::NoInput, words.front(),
                                std::generic_category().message(error));
    process_ = process;
}

StartedProcess::~StartedProcess() {
    if (ended()) return;
    using namespace std::chrono_literals;
    ::kill(static_cast<pid_t>(process_), SIGTERM);
    for (auto left = 3000ms; left > 0ms && !ended(); left -= 10ms) std::this_thread::sleep_for(10ms);
}

std::optional<int> StartedProcess::ended() noexcept {
    int status = 0;
    const auto process = static_cast<pid_t>(process_);
    if (!code_ && ::waitpid(process, &status, WNOHANG) == process)
        code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 1;
    return code_;
}

} // namespace app
