/// The participants of a fault test: started, killed, replaced, and watched.
#pragma once

#include "process/ipc/board.h"
#include "support/child_process.h"
#include "support/ipc_instance.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace test {

/// How often to repeat: RT_IPC_ROUNDS multiplies what a quick run does.
inline int rounds(int quick) {
    const char* factor = std::getenv("RT_IPC_ROUNDS");
    return factor == nullptr ? quick : std::max(1, quick * std::atoi(factor));
}

/// The time within which a slow machine answers, too; a process that takes longer hangs.
inline constexpr std::chrono::seconds kLongest{10};

/// One instance with its server (number 0 on the board) and others.
class Troupe {
  public:
    Troupe() : path_(instance.folder() / "board"), board(path_) {}

    /// Starts or replaces participant `index`.
    void start(int index, const std::string& role, const std::vector<std::string>& options = {},
               const std::string& dieAt = "") {
        ChildSettings settings;
        if (!dieAt.empty()) settings.environment.emplace_back("RT_DIE_AT", dieAt);
        put(index, participant(index, role, options, settings));
    }
    ChildProcess participant(int index, const std::string& role, const std::vector<std::string>& options,
                             const ChildSettings& settings) const {
        std::vector<std::string> words{role, instance.name(), path_, std::to_string(index)};
        words.insert(words.end(), options.begin(), options.end());
        return {RT_IPC_PARTICIPANT, words, settings};
    }
    /// Any other program as participant `index`.
    void put(int index, ChildProcess program) {
        if (members_.size() <= static_cast<std::size_t>(index))
            members_.resize(static_cast<std::size_t>(index) + 1);
        members_[static_cast<std::size_t>(index)] = std::move(program);
    }
    ChildProcess& operator[](int index) { return members_[static_cast<std::size_t>(index)]; }
    int size() const { return static_cast<int>(members_.size()); }

    /// Each of these participants gets on, within the time.
    bool progresses(const std::vector<int>& indices, Clock::duration within = kLongest) {
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
    std::vector<ChildProcess> members_;
};

} // namespace test
