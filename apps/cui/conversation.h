/// Commands to one server, and its answers.
#pragma once

#include "common/process/exit_codes.h"

#include "ipc/endpoint/client.h"

#include <chrono>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

namespace cui {

/// A command failed: what to print, and the exit code that tells of it.
class CommandFailure : public std::runtime_error {
  public:
    CommandFailure(app::ExitCode exitCode, const std::string& text)
        : std::runtime_error(text), code(exitCode) {}
    app::ExitCode code;
};

/// One thread. Attaches to the server with the first command.
class Conversation {
  public:
    Conversation(std::string instance, std::chrono::nanoseconds timeout)
        : instance_(std::move(instance)), timeout_(timeout) {}

    /// The server's answer; `work` is what the command takes beside the time to wait. Throws CommandFailure,
    /// ipc::Error, and rtcore::FileError when a signal asked to stop.
    std::string request(std::string_view command, std::chrono::nanoseconds work = {});
    /// The same for work that takes as long as it takes. Meanwhile `progress` is asked for every now and then
    /// and `show` told the answer; the time to wait begins anew with each. Where a signal asks to stop,
    /// `giveUp` is sent, and the end of the work waited for.
    struct LongWork {
        std::string progress, giveUp;
        std::function<void(const std::string&)> show;
    };
    std::string attend(std::string_view command, const LongWork& work);
    /// Ends the server and waits until it has ended.
    void quit(std::string_view command);
    /// Lets go of the server until the next command.
    void hangUp() { client_.reset(); }
    const std::string& instance() const { return instance_; }

  private:
    ipc::Client& client();
    using Clock = std::chrono::steady_clock;
    ipc::Ticket send(std::string_view command, Clock::time_point deadline);
    ipc::Reply ask(std::string_view command, std::chrono::nanoseconds work);
    std::string textOf(const ipc::Reply& reply) const;

    std::string instance_;
    std::chrono::nanoseconds timeout_;
    std::unique_ptr<ipc::Client> client_;
};

} // namespace cui
