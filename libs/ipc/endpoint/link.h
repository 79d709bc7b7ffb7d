/// The way from a viewer or a client to the server's control segment, and whether the server still lives.
#pragma once

#include "ipc/endpoint/link_state.h"
#include "ipc/layout/control_block.h"
#include "ipc/platform/names.h"
#include "ipc/platform/segment.h"
#include "ipc/platform/system.h"

#include <optional>
#include <string>

namespace ipc {

/// The handshake that this program expects.
Handshake ownHandshake();

/// The facts in a control segment about itself, copied and checked. Nothing when it is not (yet) one.
struct ControlFacts {
    Handshake handshake{};
    std::uint64_t epoch = 0;
    std::int64_t serverProcess = 0;
};
std::optional<ControlFacts> readControlFacts(const Segment& segment);

/// Whether the server of a control segment lives: another process has the lock. A server of another version
/// may lock something else; it lives when its pulse moves, which is watched for up to 50 ms.
bool serverLives(const Segment& segment);

/// One epoch of one server. One thread.
class Link {
  public:
    /// Nothing when no living server answers to the name (yet). Throws Error WrongVersion, NotYours.
    static std::optional<Link> open(const Names& names, Access access);

    ControlBlock& block() const { return *static_cast<ControlBlock*>(segment_.data()); }
    std::uint64_t epoch() const { return facts_.epoch; }
    std::int64_t serverProcess() const { return facts_.serverProcess; }
    /// Takes the slot of a client, until this object is gone. False when another client has it.
    bool tryLockSlot(int slot) const { return segment_.tryLock(clientLock(slot)); }

    /// The server's next epoch; or this one again, when it turns out to live (its phase was overwritten).
    /// Nothing, too, while the system is short of something. Otherwise as open. For a link that is Gone.
    std::optional<Link> successor(Access access) const;

    /// Cheap enough for every call. Silence alone never means death: a silent server that holds its lock is
    /// busy.
    LinkState check();

  private:
    Link(const Names& names, Segment segment, ControlFacts facts);
    LinkState probe(Clock::time_point now) const;
    bool replaced() const;

    Names names_;
    Segment segment_;
    ControlFacts facts_;
    std::uint64_t pulse_ = 0;
    Clock::time_point lastPulse_, lastProbe_;
    LinkState state_ = LinkState::Connected;
};

} // namespace ipc
