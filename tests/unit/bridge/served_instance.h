/// A server of the test's own process, which does what the test says while it waits for something.
#pragma once

#include "ipc/endpoint/server.h"
#include "support/child_process.h"
#include "support/ipc_instance.h"

#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace test {

class ServedInstance {
  public:
    const std::string& name() const { return instance_.name(); }
    ipc::Server& server() { return *server_; }
    void start() {
        server_ = std::make_unique<ipc::Server>(ipc::ServerOptions{
            .instance = name(), .width = 64, .height = 48, .patience = std::chrono::seconds(2)});
    }
    void stop() { server_.reset(); }

    /// Serves until it holds; false where it does not for long. Keys that are down are remembered.
    bool until(const std::function<bool()>& holds) {
        return eventually(
            [&] {
                if (server_) serve();
                return holds();
            },
            std::chrono::seconds(10));
    }
    /// A frame of this size that differs from the one before; `idle`: the view rests.
    std::uint64_t publish(std::uint32_t width = 64, std::uint32_t height = 48, bool idle = false) {
        ++shown_;
        std::vector<std::byte> pixels(std::size_t(4) * width * height);
        for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = static_cast<std::byte>(i * 7 + shown_);
        ipc::Status status;
        status.width = width;
        status.height = height;
        status.idle = idle ? 1 : 0;
        status.eye[0] = static_cast<float>(shown_);
        server_->setStatus(status);
        ipc::FrameInfo info;
        info.width = width;
        info.height = height;
        return server_->publishFrame(info, pixels);
    }

    /// Called for each command that comes. Without it, or where it returns false, the command is answered "".
    std::function<bool(const ipc::Command&)> onCommand;
    std::vector<std::string> commands; ///< all but `state`, `bindings` and `messages`
    ipc::KeyState keys;
    std::vector<std::uint32_t> presses = std::vector<std::uint32_t>(256); ///< of each key, so far

  private:
    void serve() {
        keys = server_->keys();
        for (std::size_t key = 0; key < presses.size(); ++key) presses[key] += keys.presses[key];
        for (const ipc::Command& command : server_->takeCommands()) {
            const bool own =
                command.text == "state" || command.text == "bindings" || command.text.starts_with("messages");
            if (!own) commands.push_back(command.text);
            if (!onCommand || !onCommand(command)) server_->answer(command);
        }
    }

    IpcInstance instance_;
    std::unique_ptr<ipc::Server> server_;
    std::uint64_t shown_ = 0;
};

} // namespace test
