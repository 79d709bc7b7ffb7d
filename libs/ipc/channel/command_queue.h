/// The queue of one client's commands: Boost's message queue, used without ever waiting on it: a process
/// killed while it waits inside a queue would block the next one for good.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace ipc {

enum class QueueResult {
    Done,
    Nothing, ///< the queue is full (send) or empty (receive)
    Broken,  ///< a process died inside, or it was tampered with: discard it
};

/// The client's end: makes the queue, and removes its name unless the server has done so. One thread.
class CommandSender {
  public:
    /// Throws Error NoSpace, NotYours, System.
    explicit CommandSender(const std::string& name);
    ~CommandSender();
    CommandSender(CommandSender&&) noexcept;
    CommandSender& operator=(CommandSender&&) noexcept;

    QueueResult trySend(std::span<const std::byte> message);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The server's end. One thread.
class CommandReceiver {
  public:
    /// Opens the queue and removes its name, so that nothing is left when both are gone. Broken when it is
    /// not there, not of this user alone, or not of the agreed dimensions.
    static QueueResult open(const std::string& name, CommandReceiver& receiver);

    CommandReceiver();
    ~CommandReceiver();
    CommandReceiver(CommandReceiver&&) noexcept;
    CommandReceiver& operator=(CommandReceiver&&) noexcept;

    /// Done: `message` holds what was sent.
    QueueResult tryReceive(std::vector<std::byte>& message);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace ipc
