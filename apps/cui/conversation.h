/// Commands to one server, and its answers.
#pragma once

#include "common/process/exit_codes.h"

#include "ipc/endpoint/client.h"

#include <chrono>
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
    /// Ends the server and waits until it has ended.
    void quit(std::string_view command);
    /// Lets go of the server until the next command.
    void hangUp() { client_.reset(); }
    const std::string& instance() const { return instance_; }

  private:
    ipc::Client& client();
    ipc::Reply ask(std::string_view command, std::chrono::nanoseconds work);

    std::string instance_;
    std::chrono::nanoseconds timeout_;
    std::unique_ptr<ipc::Client> client_;
};

} // namespace cui
