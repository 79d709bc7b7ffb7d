#include "bridge/server_start.h"

#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <system_error>
#include <thread>
#include <vector>

extern char** environ;

namespace bridge {

namespace {

std::filesystem::path serverProgram() {
    const char* const chosen = std::getenv("RT_SERVER"); // NOLINT(concurrency-mt-unsafe)
    std::filesystem::path program =
        chosen != nullptr && *chosen != '\0' ? std::filesystem::path(chosen) : rtcore::programFolder() / "RTServer";
    std::error_code unknown;
    if (std::filesystem::exists(program, unknown)) return program;
    throw rtcore::FileError(rtcore::FailureKind::NoInput, program.string(),
                            "the RTServer is missing; install it beside RTBridge or name it in RT_SERVER");
}

} // namespace

StartedServer::StartedServer(const std::filesystem::path& scene, const std::string& instance) {
    const std::string program = serverProgram().string();
    std::error_code unknown;
    if (!std::filesystem::exists(scene, unknown))
        throw rtcore::FileError(rtcore::FailureKind::NoInput, scene.string(), "there is no such file");
    std::vector<std::string> words{program, "--instance=" + instance, "--parent=" + std::to_string(::getpid()), "--", scene.string()};
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const int error = ::posix_spawn(&process_, program.c_str(), nullptr, nullptr, arguments.data(), environ);
    if (error != 0)
        throw rtcore::FileError(rtcore::FailureKind::NoInput, program, std::system_category().message(error));
}

StartedServer::~StartedServer() {
    if (ended()) return;
    ::kill(process_, SIGTERM);
    using namespace std::chrono_literals;
    for (auto left = 3000ms; left > 0ms && !ended(); left -= 10ms) std::this_thread::sleep_for(10ms);
}

std::optional<int> StartedServer::ended() {
    int status = 0;
    if (!code_ && ::waitpid(process_, &status, WNOHANG) == process_) code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 1;
    return code_;
}

} // namespace bridge
