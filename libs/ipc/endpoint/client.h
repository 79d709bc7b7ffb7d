/// Commands a server: text commands with answers, and keys. Also sees what a Viewer sees. Up to 32 clients
/// per server. This header, viewer.h and instances.h are all that another program needs;
/// docs/example_client.cpp shows how.
#pragma once

#include "ipc/endpoint/frame.h"
#include "ipc/endpoint/instances.h"
#include "ipc/endpoint/link_state.h"
#include "ipc/endpoint/viewer.h"
#include "ipc/layout/status.h"
#include "ipc/platform/error.h"

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace ipc {

enum class ReplyStatus {
    Done,     ///< the server did it
    Failed,   ///< the server could not; the text says why
    Lost,     ///< the server ended before it answered: it may have done it or not
    TimedOut, ///< no answer yet; it may still come
    NotSent,  ///< no server, or no room in the queue until the deadline
};

struct Reply {
    ReplyStatus status = ReplyStatus::NotSent;
    std::string text;        ///< up to 65,520 bytes, as the server gave it
    int code = 0;            ///< of Failed: the exit code that suits it, 1..255, as the server gave it
    std::string detail = {}; ///< the text for programs, in a form of the server's own; may be empty
};

/// A command that was sent; 0 = none.
using Ticket = std::uint64_t;

enum class SendStatus {
    Sent,
    Full,     ///< 32 commands wait already; nothing was sent
    NoServer, ///< nothing was sent
};

/// One thread per object. A client whose server dies finds the next one of that instance by itself, with its
/// keys still down; commands without an answer are Lost then.
class Client {
  public:
    /// Waits up to `patience` for a server. Throws Error: BadName, NoServer, NoSlot, WrongVersion, NotYours,
    /// NoSpace, System.
    /// `keyRestraint`: the higher, up to kKeyRestraints, the less the server lets its keys do.
    explicit Client(const std::string& instance = "default",
                    std::chrono::nanoseconds patience = std::chrono::seconds(2),
                    std::uint32_t keyRestraint = 0);
    /// Releases its keys. Commands that the server has not taken yet may be lost: see flush.
    ~Client();
    Client(const Client&) = delete;
    Client& operator=(const Client&) = delete;

    /// Looks whether the server lives; attaches to its successor. Every other function does it, too. Throws
    /// Error WrongVersion, NotYours, NoSlot or NoSpace when there is one that cannot be attached to. What the
    /// system refuses for the moment, such as another descriptor, is tried again with the next call.
    LinkState update();
    std::uint64_t epoch() const; ///< another number after another server, or another start of it
    std::int64_t serverProcess() const;

    /// Sends a command of up to 8192 bytes without NUL (else Error TooLarge). Never waits. `ticket` is for
    /// wait(); null: no answer is wanted.
    SendStatus send(std::string_view command, Ticket* ticket = nullptr);
    /// The answer to a command; each is given once. At most 1024 answers that were not collected are kept.
    Reply wait(Ticket ticket, std::chrono::nanoseconds timeout);
    /// Sends, again and again while the queue is full or no server there, and waits for the answer.
    Reply request(std::string_view command, std::chrono::nanoseconds timeout = std::chrono::seconds(2));
    /// Until the server has taken all that was sent; false when it did not in time, or is gone.
    bool flush(std::chrono::nanoseconds timeout);

    /// Key codes are 0..255; others are ignored.
    void pressKey(int key);
    void releaseKey(int key);
    void releaseAllKeys();

    bool readFrame(Frame& frame); ///< as Viewer::readFrame
    /// Woken by the server the moment that a frame is there.
    bool waitForFrame(Frame& frame, std::chrono::nanoseconds timeout);
    Status status();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace ipc
