/// The control segment: identity and state of the server, and a slot for each commanding client.
/// Everything is zero when the segment is made. Each field names its only writer. No pointers: the two sides
/// map it at different addresses. docs/protocol.md describes the protocol.
#pragma once

#include "ipc/layout/doorbell.h"
#include "ipc/layout/limits.h"
#include "ipc/layout/sequenced.h"
#include "ipc/layout/status.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace ipc {

static_assert(std::atomic<std::uint64_t>::is_always_lock_free &&
                  std::atomic<std::uint32_t>::is_always_lock_free,
              "other atomics are not shared between processes");

inline constexpr std::uint64_t kControlMagic = 0x314C544353545221; ///< "!RTSCTL1"

/// Bytes of the segment that are locked. A lock is the only proof that its holder lives.
inline constexpr std::uint64_t kServerLock = 0;
constexpr std::uint64_t clientLock(int slot) { return 1 + static_cast<std::uint64_t>(slot); }

/// Facts that both sides must agree on before they read on. Never reordered, only appended to.
struct Handshake {
    std::uint32_t protocolVersion;
    std::uint32_t controlBytes; ///< sizeof(ControlBlock)
    std::uint32_t boostVersion; ///< the layout of a message queue is Boost's own
    std::uint16_t pointerBytes;
    std::uint16_t byteOrder; ///< 0x0102 as the writer sees it
    friend bool operator==(const Handshake&, const Handshake&) = default;
};
static_assert(sizeof(Handshake) == 16);

enum class ServerPhase : std::uint32_t {
    Running = 0,
    Left = 1,     ///< ended in good order
    Replaced = 2, ///< the same server goes on with a new control segment
};

/// It and the pulse stay where they are in all versions, so that each can tell of the others.
struct alignas(64) ControlHeader {
    std::atomic<std::uint64_t> magic; ///< server, stored last: the fields are complete from then on
    Handshake handshake;
    std::uint64_t epoch; ///< random: another start of the server has another one
    std::int64_t serverProcess;
    std::byte reserved[512]; ///< so that the pulse lies where protocol 1 has it
};

struct alignas(64) ServerPulse {
    std::atomic<std::uint64_t> alive;           ///< server: counts while it serves or waits
    std::atomic<std::uint64_t> progress;        ///< server: counts published frames
    std::atomic<std::uint64_t> frameGeneration; ///< server: names the frame segment; 0 = none yet
    std::atomic<ServerPhase> phase;             ///< server
};

struct alignas(64) KeyBoard {
    std::atomic<std::uint64_t> down[kMaxKeys / 64]; ///< client: a bit per key
    std::atomic<std::uint32_t>
        presses[kMaxKeys]; ///< client: counts up with each press, so that no tap is lost
};

struct ReplyRing {
    alignas(64) std::atomic<std::uint64_t> head; ///< server: bytes ever written
    alignas(64)
        std::atomic<std::uint64_t> tail; ///< client: bytes ever read (the server sets it to 0 at the start)
    alignas(64) std::byte bytes[kReplyBytes];
};

enum class DropReason : std::uint32_t {
    None = 0,
    NoQueue = 1,     ///< the queue could not be opened or has other dimensions
    BrokenQueue = 2, ///< a process died inside the queue
    Malformed = 3,   ///< too many malformed messages within a second
    BadReplies = 4,  ///< the reply ring is invalid
};

/// Slot k belongs to the process that holds the lock of byte clientLock(k).
struct alignas(64) ClientSlot {
    std::atomic<std::uint64_t> clientTag;    ///< client, stored last: random, names its queue; 0 = no client
    std::atomic<std::int64_t> clientProcess; ///< client
    std::atomic<std::uint32_t> wantsFrames;  ///< client: 1 = ring my bell when a frame is published
    std::atomic<std::uint32_t> keyRestraint; ///< client, before clientTag: 0..kKeyRestraints
    alignas(64) std::atomic<std::uint64_t> servedTag; ///< server: the tag that it serves
    std::atomic<std::uint64_t> droppedTag;            ///< server: the tag that it will not serve (again)
    std::atomic<DropReason> dropReason;               ///< server, stored before droppedTag
    std::atomic<std::uint64_t> taken;     ///< server: the last command that it took from the queue
    std::atomic<std::uint64_t> malformed; ///< server: messages thrown away
    std::atomic<std::uint32_t>
        repliesWait; ///< server: 1 = there are more replies than room; ring when you read
    Doorbell bell;   ///< rung by the server: a reply or a frame is there
    KeyBoard keys;
    ReplyRing replies;
};

struct ControlBlock {
    ControlHeader header;
    ServerPulse pulse;
    Doorbell bell; ///< rung by clients: a command, a key or a client is there
    Sequenced<Status> status;
    ClientSlot clients[kMaxClients];
};
static_assert(std::is_trivially_copyable_v<Handshake> && std::is_standard_layout_v<ControlBlock>);
static_assert(offsetof(ControlBlock, header) == 0 && offsetof(ControlHeader, magic) == 0 &&
              offsetof(ControlHeader, handshake) == 8 && offsetof(ControlHeader, epoch) == 24);
static_assert(sizeof(ControlHeader) == 576 && sizeof(ServerPulse) == 64 && sizeof(KeyBoard) == 1088 &&
              sizeof(ReplyRing) == 128 + kReplyBytes &&
              sizeof(ClientSlot) == 128 + 64 + 1088 + 128 + kReplyBytes &&
              sizeof(ControlBlock) == 576 + 64 + 64 + 192 + kMaxClients * sizeof(ClientSlot));

} // namespace ipc
