/// Runs a program as a shell would: its own process group, standard streams caught, a time limit. For tests.
#pragma once

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace test {

struct ProgramResult {
    int exitCode = -1; ///< -1 when a signal ended it
    int signal = 0;    ///< the signal that ended it, 0 when it exited
    bool timedOut = false;
    std::string output, error; ///< its stdout and stderr
};

struct ProgramSettings {
    std::filesystem::path folder = {}; ///< current folder of the program; empty = the test's
    std::vector<std::pair<std::string, std::string>> environment = {}; ///< added to the test's
    std::filesystem::path outputFile = {}; ///< stdout goes there, not into the result
    double timeoutSeconds = 120;
};

/// A program that runs. Killed with its children when the object dies.
class RunningProgram {
  public:
    RunningProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                   ProgramSettings settings = {})
        : settings_(std::move(settings)), started_(Clock::now()) {
        for (auto& ends : pipes_) {
            if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
        }
        process_ = ::fork();
        if (process_ < 0) throw std::runtime_error("no process");
        if (process_ == 0) becomeProgram(program, arguments);
        ::setpgid(process_, process_);
        for (auto& ends : pipes_) ::close(ends[1]);
    }
    ~RunningProgram() {
        if (process_ > 0) {
            ::kill(-process_, SIGKILL);
            ::waitpid(process_, nullptr, 0);
        }
        for (auto& ends : pipes_) closeEnd(ends[0]);
    }
    RunningProgram(const RunningProgram&) = delete;
    RunningProgram& operator=(const RunningProgram&) = delete;

    pid_t process() const { return process_; } ///< -1 after wait()

    /// To the program alone, not to its children.
    void send(int signal) const { ::kill(process_, signal); }

    /// Until stderr holds `text`; false when the program ends, or the time is up, before that.
    bool waitForError(const std::string& text) {
        while (result_.error.find(text) == std::string::npos) {
            if (!pump()) return false;
        }
        return true;
    }

    /// Until it ends; past the time limit it is killed.
    ProgramResult wait() {
        while (pump()) {
        }
        if (outOfTime()) {
            result_.timedOut = true;
            ::kill(-process_, SIGKILL);
        }
        int status = 0;
        while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
        }
        process_ = -1;
        if (WIFEXITED(status)) result_.exitCode = WEXITSTATUS(status);
        if (WIFSIGNALED(status)) result_.signal = WTERMSIG(status);
        return result_;
    }

  private:
    using Clock = std::chrono::steady_clock;

    [[noreturn]] void becomeProgram(const std::filesystem::path& program,
                                    const std::vector<std::string>& arguments) {
        ::setpgid(0, 0);
        for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) std::signal(signal, SIG_DFL);
        const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
        int out = pipes_[0][1];
        if (!settings_.outputFile.empty()) {
            out = ::open(settings_.outputFile.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
        }
        ::dup2(nothing, 0);
        ::dup2(out, 1);
        ::dup2(pipes_[1][1], 2);
        for (const auto& [name, value] : settings_.environment) ::setenv(name.c_str(), value.c_str(), 1);
        if (!settings_.folder.empty() && ::chdir(settings_.folder.c_str()) != 0) ::_exit(127);
        std::vector<char*> words{const_cast<char*>(program.c_str())};
        for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
        words.push_back(nullptr);
        ::execv(program.c_str(), words.data());
        ::_exit(127);
    }

    bool outOfTime() const {
        return std::chrono::duration<double>(Clock::now() - started_).count() > settings_.timeoutSeconds;
    }

    // Reads what is there; false when both streams are closed or the time is up.
    bool pump() {
        std::array<pollfd, 2> streams{{{pipes_[0][0], POLLIN, 0}, {pipes_[1][0], POLLIN, 0}}};
        if (outOfTime() || (streams[0].fd < 0 && streams[1].fd < 0)) return false;
        ::poll(streams.data(), streams.size(), 100);
        if (streams[0].revents != 0) take(pipes_[0][0], result_.output);
        if (streams[1].revents != 0) take(pipes_[1][0], result_.error);
        return true;
    }

    static void take(int& stream, std::string& text) {
        std::array<char, 65536> bytes{};
        const ssize_t count = ::read(stream, bytes.data(), bytes.size());
        if (count > 0) {
            text.append(bytes.data(), static_cast<std::size_t>(count));
        } else if (count == 0 || errno != EINTR) {
            closeEnd(stream);
        }
    }

    static void closeEnd(int& stream) {
        if (stream >= 0) ::close(stream);
        stream = -1;
    }

    ProgramSettings settings_;
    Clock::time_point started_;
    std::array<std::array<int, 2>, 2> pipes_{};
    pid_t process_ = -1;
    ProgramResult result_;
};

inline ProgramResult runProgram(const std::filesystem::path& program,
                                const std::vector<std::string>& arguments,
                                const ProgramSettings& settings = {}) {
    return RunningProgram(program, arguments, settings).wait();
}

} // namespace test
