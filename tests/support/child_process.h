/// A process that a test or a benchmark starts, stops and kills. It dies with the test.
#pragma once

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <csignal>
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace test {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

/// Sanitizers slow programs down, keep the memory that was freed, and must be a program's first library.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

inline bool eventually(const std::function<bool()>& holds, Clock::duration within = 2s) {
    const auto deadline = Clock::now() + within;
    while (!holds()) {
        if (Clock::now() > deadline) return holds();
        std::this_thread::sleep_for(200us);
    }
    return true;
}

struct ChildSettings {
    std::vector<std::pair<std::string, std::string>> environment = {}; ///< added to the test's
    std::size_t addressBytes = 0; ///< of address space that it gets; 0 = no limit
    std::string outputFile = {};  ///< its output is added there; empty: it goes where the test's goes
};

/// One process; killed by the destructor.
class ChildProcess {
  public:
    ChildProcess() = default;
    ChildProcess(const std::string& program, const std::vector<std::string>& words,
                 const ChildSettings& settings = {}) {
        std::vector<char*> arguments{const_cast<char*>(program.c_str())};
        for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
        arguments.push_back(nullptr);
        process_ = ::fork();
        if (process_ != 0) return;
        ::prctl(PR_SET_PDEATHSIG, SIGKILL); // a test that is killed leaves nobody running
        for (const auto& [name, value] : settings.environment) ::setenv(name.c_str(), value.c_str(), 1);
        if (settings.addressBytes > 0) {
            const rlimit limit{settings.addressBytes, settings.addressBytes};
            ::setrlimit(RLIMIT_AS, &limit);
        }
        if (!settings.outputFile.empty()) {
            const int file =
                ::open(settings.outputFile.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
            ::dup2(file, 1);
            ::dup2(file, 2);
        }
        ::execv(arguments[0], arguments.data());
        ::_exit(127);
    }
    /// A copy of this process that does `work`, and exits.
    explicit ChildProcess(const std::function<void()>& work) : process_(::fork()) {
        if (process_ != 0) return;
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        try {
            work();
        } catch (const std::exception& error) {
            std::fprintf(stderr, "%s\n", error.what());
        }
        ::_exit(0);
    }
    ~ChildProcess() { kill(); }
    ChildProcess(ChildProcess&& other) noexcept : process_(std::exchange(other.process_, -1)) {}
    ChildProcess& operator=(ChildProcess&& other) noexcept {
        std::swap(process_, other.process_);
        return *this;
    }

    /// A process that is told to stop does stand when this returns: the kernel only marks it at first.
    void send(int signal) const {
        ::kill(process_, signal);
        siginfo_t info{};
        if (signal == SIGSTOP && process_ > 0)
            eventually([&] {
                return ::waitid(P_PID, static_cast<id_t>(process_), &info, WSTOPPED | WNOHANG) < 0 ||
                       info.si_pid != 0;
            });
    }
    void kill() {
        if (process_ <= 0) return;
        ::kill(process_, SIGKILL);
        ::waitpid(process_, nullptr, 0);
        process_ = -1;
    }
    /// Its status as waitpid gives it; -1 when it is not over in time.
    int wait(Clock::duration within = 3s) {
        int status = -1;
        const bool over =
            eventually([&] { return process_ <= 0 || ::waitpid(process_, &status, WNOHANG) > 0; }, within);
        if (over) process_ = -1;
        return over ? status : -1;
    }
    pid_t process() const { return process_; }

  private:
    pid_t process_ = -1;
};

} // namespace test
