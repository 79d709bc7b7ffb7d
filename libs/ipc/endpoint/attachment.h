/// One client's hold on a slot of one epoch of a server: the queue, the tag, the replies.
#pragma once

#include "ipc/channel/command_queue.h"
#include "ipc/channel/keys.h"
#include "ipc/channel/reply_channel.h"
#include "ipc/endpoint/link.h"

namespace ipc {

/// Locks the first free slot, until `link` is gone. Throws Error NoSlot.
int takeSlot(const Names& names, const Link& link);

/// One thread. `link` must outlive it.
class Attachment {
  public:
    /// Makes a queue, then claims the slot with the keys that are down and their restraint. Does not wait for
    /// the server.
    Attachment(const Names& names, const Link& link, int slot, const KeyWriter& keys,
               std::uint32_t restraint);
    /// Gives the slot back.
    ~Attachment();
    Attachment(const Attachment&) = delete;
    Attachment& operator=(const Attachment&) = delete;

    ClientSlot& slot() const { return *slot_; }
    /// False when the server dropped this client or took it for dead, or when another process overwrote its
    /// tag: attach again.
    bool accepted() const;
    QueueResult trySend(const std::vector<std::byte>& message);
    RingResult tryReceive(ReplyRecord& reply);
    /// The last command that the server took.
    std::uint64_t taken() const;

  private:
    bool served() const { return slot_->servedTag.load(std::memory_order_acquire) == tag_; }

    ControlBlock* block_;
    ClientSlot* slot_;
    std::uint64_t tag_;
    CommandSender sender_;
    ReplyReader replies_;
};

} // namespace ipc
