/// Looks at a server without being noticed: frames and status, any number of viewers per server.
#pragma once

#include "ipc/endpoint/frame.h"
#include "ipc/endpoint/link_state.h"
#include "ipc/layout/status.h"
#include "ipc/platform/error.h"

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

namespace ipc {

/// One thread per object. Everything that comes out of shared memory was copied and checked.
class Viewer {
  public:
    /// Waits up to `patience` for a server of this instance. Throws Error: BadName, NoServer, WrongVersion,
    /// NotYours, System.
    explicit Viewer(const std::string& instance = "default",
                    std::chrono::nanoseconds patience = std::chrono::seconds(2));
    ~Viewer();
    Viewer(const Viewer&) = delete;
    Viewer& operator=(const Viewer&) = delete;

    /// Looks whether the server lives; finds its successor. Throws Error WrongVersion or NotYours when that
    /// does not suit.
    LinkState update();
    /// Another number after another server, or another start of it.
    std::uint64_t epoch() const;
    std::int64_t serverProcess() const;

    /// True: `frame` now holds a newer frame. False: nothing newer; `frame.info` is as before, but its pixels
    /// may be rubbish when a writer was too fast (draw them before the next call). Never waits; a copy at
    /// memory speed.
    bool readFrame(Frame& frame);
    /// Looks every millisecond.
    bool waitForFrame(Frame& frame, std::chrono::nanoseconds timeout);

    /// The newest status; the last one known when the server is gone.
    Status status();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace ipc
