/// The participants of a fault test: started, killed, replaced, and watched.
#pragma once

#include "process/ipc/board.h"
#include "support/ipc_instance.h"

#include <chrono>
#include <cstdlib>
#include <functional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <csignal>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace test {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

/// How often to repeat: RT_IPC_ROUNDS multiplies what a quick run does.
inline int rounds(int quick) {
    const char* factor = std::getenv("RT_IPC_ROUNDS");
    return factor == nullptr ? quick : std::max(1, quick * std::atoi(factor));
}

inline bool eventually(const std::function<bool()>& holds, Clock::duration within = 2s) {
    const auto deadline = Clock::now() + within;
    while (!holds()) {
        if (Clock::now() > deadline) return holds();
        std::this_thread::sleep_for(200us);
    }
    return true;
}

/// One process; killed by the destructor.
class Participant {
  public:
    Participant() = default;
    Participant(const std::vector<std::string>& words, const std::string& dieAt = "") {
        std::vector<char*> arguments{const_cast<char*>(RT_IPC_PARTICIPANT)};
        for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
        arguments.push_back(nullptr);
        process_ = ::fork();
        if (process_ != 0) return;
        ::prctl(PR_SET_PDEATHSIG, SIGKILL); // a test that is killed leaves nobody running
        if (!dieAt.empty()) ::setenv("RT_DIE_AT", dieAt.c_str(), 1);
        ::execv(arguments[0], arguments.data());
        ::_exit(127);
    }
    ~Participant() { kill(); }
    Participant(Participant&& other) noexcept : process_(std::exchange(other.process_, -1)) {}
    Participant& operator=(Participant&& other) noexcept {
        std::swap(process_, other.process_);
        return *this;
    }

    void send(int signal) const { ::kill(process_, signal); }
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

/// One instance with its server (number 0 on the board) and others.
class Troupe {
  public:
    Troupe() : path_(instance.folder() / "board"), board(path_) {}

    /// Starts or replaces participant `index`.
    void start(int index, const std::string& role, const std::vector<std::string>& options = {},
               const std::string& dieAt = "") {
        if (members_.size() <= static_cast<std::size_t>(index))
            members_.resize(static_cast<std::size_t>(index) + 1);
        std::vector<std::string> words{role, instance.name(), path_, std::to_string(index)};
        words.insert(words.end(), options.begin(), options.end());
        members_[static_cast<std::size_t>(index)] = Participant(words, dieAt);
    }
    Participant& operator[](int index) { return members_[static_cast<std::size_t>(index)]; }
    int size() const { return static_cast<int>(members_.size()); }

    /// Each of these participants gets on, within the time.
    bool progresses(const std::vector<int>& indices, Clock::duration within = 1s) {
        std::vector<std::uint64_t> before;
        for (const int index : indices) before.push_back(board[index].progress);
        return eventually(
            [&] {
                for (std::size_t i = 0; i < indices.size(); ++i) {
                    if (board[indices[i]].progress <= before[i]) return false;
                }
                return true;
            },
            within);
    }
    std::vector<int> all() const {
        std::vector<int> indices;
        for (int i = 0; i < size(); ++i) indices.push_back(i);
        return indices;
    }
    std::uint64_t sum(std::atomic<std::uint64_t> Counters::*counter) {
        std::uint64_t total = 0;
        for (int i = 0; i < size(); ++i) total += (board[i].*counter).load();
        return total;
    }
    /// Ends all in good order, clients first; nothing may be left in shared memory.
    bool leavesNothing() {
        for (int i = size() - 1; i >= 0; --i) {
            members_[static_cast<std::size_t>(i)].send(SIGTERM);
            if (members_[static_cast<std::size_t>(i)].wait() != 0) return false;
        }
        return instance.segments().empty();
    }

    IpcInstance instance;

  private:
    std::string path_;

  public:
    Board board;

  private:
    std::vector<Participant> members_;
};

} // namespace test
