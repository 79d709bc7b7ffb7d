/// A server: publishes frames and status, takes commands and keys. This header is all that a server program
/// needs.
#pragma once

#include "ipc/layout/frame_info.h"
#include "ipc/layout/key_state.h"
#include "ipc/layout/limits.h"
#include "ipc/layout/status.h"
#include "ipc/platform/error.h"

#include <bitset>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ipc {

struct ServerOptions {
    std::string instance = "default"; ///< 1 to 32 letters, digits, '_' or '-'
    std::uint32_t width = 1280; ///< pixels that memory is reserved for at once; more is reserved when needed
    std::uint32_t height = 720;
    std::uint32_t frameSlots = 3; ///< 3..8; more let slow viewers copy longer before the writer comes round
    /// How long to wait for a predecessor that is just dying.
    std::chrono::nanoseconds patience = std::chrono::seconds(2);
};

struct Command {
    int slot = -1;              ///< 0..31, of the client
    std::uint64_t client = 0;   ///< another number for each client that ever had the slot
    std::uint64_t sequence = 0; ///< counts up within a client
    bool wantsAnswer = false;
    std::string text; ///< up to 8192 bytes without NUL, otherwise as a client sent it
};

struct ReplyRecord;

using ClientSet = std::bitset<kMaxClients>; ///< by slot

/// One thread at a time, apart from the memory that beginFrame returns. Create it after fork and daemon, in
/// the process that serves. No function waits for a client, whatever that does, apart from wait().
class Server {
  public:
    /// Takes the instance over from a dead predecessor and removes what that left. Throws Error: BadName,
    /// AlreadyRunning, NoSpace, NotYours, System.
    explicit Server(const ServerOptions& options = {});
    /// Tells the clients and removes all names.
    ~Server();
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    std::uint64_t epoch() const;

    // --- Requests ---

    /// Sleeps until a command, a key or a client comes or goes, at most `timeout`. False when nothing came; a
    /// signal ends the sleep early. Costs well under 1% of a core.
    bool wait(std::chrono::nanoseconds timeout);
    /// The commands of the clients, up to 16 of each, each client's in order. Call it at least once per
    /// frame; it also notices dead clients, and publishes everything anew when its names were removed.
    /// Throws Error AlreadyRunning when another server took the instance over, which takes a removed lock
    /// file.
    /// The commands of the clients in `later` stay in their queues, so that the caller need not store
    /// commands that it cannot run yet.
    std::vector<Command> takeCommands(const ClientSet& later = {});
    /// The command is done. An answer is to be given once to each command that wants one, now or later;
    /// others and those of dead clients are ignored. Text beyond 65,520 bytes is cut off. A client with 64
    /// open answers is not served until some are given.
    /// `detail`: the same for programs, in a form that this library does not know; left out where both are
    /// more than an answer holds.
    void answer(const Command& command, std::string_view text = {}, std::string_view detail = {});
    /// The same of a command that failed: the exit code, 1..255, that suits it, and why.
    void refuse(const Command& command, int code, std::string_view text, std::string_view detail = {});
    /// Whether the client that sent it is still connected, as of the last takeCommands() or wait().
    bool isConnected(const Command& command) const;
    /// The keys that any client holds down, and how often each was pressed since the last call.
    KeyState keys();
    int clients() const;             ///< that command; viewers are not known
    std::uint64_t malformed() const; ///< messages thrown away so far

    // --- Frames ---

    /// Memory for frames of up to width x height pixels, 1..16384 each. Gives a frame that was begun up when
    /// that means more than before. Throws Error NoSpace or TooLarge. In either case the last frame stands.
    void reserveFrame(std::uint32_t width, std::uint32_t height);
    /// A frame of width x height pixels, to be drawn in place by any threads. It holds rubbish. Reserves what
    /// it needs. May be called again instead of publishFrame, to give the frame up.
    std::span<std::byte> beginFrame(std::uint32_t width, std::uint32_t height);
    /// Shows the frame that was begun. Uses all of `info` but number, size and time.
    /// Returns the frame's number.
    std::uint64_t publishFrame(const FrameInfo& info = {});
    /// Both at once: copies 4 * info.width * info.height bytes.
    std::uint64_t publishFrame(const FrameInfo& info, std::span<const std::byte> pixels);

    void setStatus(const Status& status);

  private:
    void reply(const Command& command, ReplyRecord record);

    struct State;
    std::unique_ptr<State> state_;
};

} // namespace ipc
