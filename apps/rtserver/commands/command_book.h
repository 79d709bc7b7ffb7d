/// The commands that clients sent and that are not done yet.
#pragma once

#include "ipc/endpoint/server.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <utility>
#include <vector>

namespace rtserver {

/// The state of a command that was run.
enum class Served {
    Done,   ///< its answer is given, or comes later
    Again,  ///< it waits for a frame, or for a scene: to be run again in the next turn
    Beside, ///< it is at work beside the server: what the same client sends waits for resume()
};

/// Commands of one client run in their order; no client waits for the commands of another, nor for those of a
/// client that had its slot before. One thread at a time.
class CommandBook {
  public:
    using Run = std::function<Served(const ipc::Command&)>;

    void add(ipc::Command command);
    /// Something was added since the last serve().
    bool hasNew() const { return new_; }
    /// Runs what can be run; the rest stays.
    void serve(const Run& run);
    /// The command that this client had Beside is done.
    void resume(std::uint64_t client) { std::erase(beside_, client); }

    /// Something of this client is not done, so that its next command has to wait.
    bool hasMore(std::uint64_t client) const;
    /// One command of each client of which so many are not done.
    std::vector<const ipc::Command*> ofClientsWith(std::size_t number) const;
    /// A command of this client is Beside.
    bool isBeside(std::uint64_t client) const;
    /// As of the last serve(): a command waits to be run again.
    bool waits() const { return !waiting_.empty(); }
    /// Takes those out that are to be forgotten, so that no frame is held for them.
    void forgetWaiting(const std::function<bool(const ipc::Command&)>& forgotten);
    /// Takes those out: one of each client that waits.
    std::vector<ipc::Command> takeWaiting();
    /// Clients that wait have sent more, which waits behind.
    bool obstructs() const;
    /// Takes the commands of these out that wait.
    std::vector<ipc::Command> takeObstructing();

  private:
    std::vector<std::uint64_t> obstructed() const;
    std::vector<ipc::Command> takeFirst(std::vector<std::uint64_t> clients);

    std::deque<ipc::Command> pending_;
    bool new_ = false;
    std::vector<std::uint64_t> beside_;  ///< clients
    std::vector<std::uint64_t> waiting_; ///< clients whose first command was to be run again
};

} // namespace rtserver
