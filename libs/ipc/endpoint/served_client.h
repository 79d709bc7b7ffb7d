/// One client's slot as the server sees it. Believes nothing that it reads there.
#pragma once

#include "ipc/channel/command_queue.h"
#include "ipc/channel/keys.h"
#include "ipc/channel/reply_channel.h"
#include "ipc/endpoint/server.h"
#include "ipc/platform/names.h"
#include "ipc/platform/system.h"

#include <deque>
#include <string>
#include <vector>

namespace ipc {

/// One thread.
class ServedClient {
  public:
    bool active() const { return tag_ != 0; }

    /// Sees whether the slot changed hands. The last commands of a client that left go to `commands`. True
    /// when it did.
    bool look(int index, ClientSlot& slot, const Names& names, std::uint64_t epoch,
              std::vector<Command>& commands);
    /// Restores what only the server writes, where another process overwrote it.
    void repair(ClientSlot& slot) const;
    /// To be called when the slot's lock was free while `tag` was in it: its owner is dead.
    static void declareDead(ClientSlot& slot, std::uint64_t tag);
    std::uint64_t tag() const { return tag_; }

    /// Sends replies that wait for room, then takes up to `limit` commands.
    void serve(ClientSlot& slot, std::uint64_t epoch, int limit, std::vector<Command>& commands);
    /// `code`: 0 done, else failed.
    void answer(ClientSlot& slot, const Command& command, ReplyRecord reply);
    void collectKeys(const ClientSlot& slot, KeyState& state) { keys_.collect(slot.keys, state, restraint_); }
    /// The queue is drained, the client served no more.
    void leave(ClientSlot& slot, std::uint64_t epoch, std::vector<Command>& commands);

    std::uint64_t malformed() const { return malformed_; }

  private:
    void adopt(int index, ClientSlot& slot, const Names& names, std::uint64_t tag);
    void drop(ClientSlot& slot, DropReason reason);
    bool sendWaiting(ClientSlot& slot);
    QueueResult takeOne(ClientSlot& slot, std::uint64_t epoch, std::vector<Command>& commands);
    bool tooManyMalformed();

    int index_ = -1;
    std::uint64_t tag_ = 0;
    std::uint64_t dropped_ = 0; ///< the last tag that is not served (again)
    CommandReceiver queue_;
    std::uint64_t lastSequence_ = 0;
    int unanswered_ = 0;
    ReplyWriter replies_;
    std::deque<ReplyRecord> waiting_; ///< for room in the ring
    KeyReader keys_;
    std::uint32_t restraint_ = 0; ///< as it was when the client came
    std::vector<std::byte> buffer_;
    std::uint64_t malformed_ = 0; ///< of all clients that this slot ever had
    Clock::time_point windowStart_;
    int inWindow_ = 0;
};

} // namespace ipc
