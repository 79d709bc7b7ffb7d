#include "ipc/endpoint/attachment.h"

#include "ipc/platform/error.h"
#include "ipc/platform/fault_point.h"
#include "ipc/platform/rules.h"

namespace ipc {

int takeSlot(const Names& names, const Link& link) {
    for (int slot = 0; slot < kMaxClients; ++slot) {
        if (!link.tryLockSlot(slot)) continue;
        // The process that made these had the lock, and is dead.
        for (const std::string& queue : segmentNames(names.queuePrefix(slot))) Segment::remove(queue);
        return slot;
    }
    throw Error(Problem::NoSlot, "server '{0}' has {1} clients, and takes no more; end one",
                {names.instance(), std::to_string(kMaxClients)});
}

Attachment::Attachment(const Names& names, const Link& link, int slot, const KeyWriter& keys,
                       std::uint32_t restraint)
    : block_(&link.block()), slot_(&block_->clients[slot]), tag_(randomTag()),
      sender_(names.queue(slot, tag_)) {
    faultPoint("queue made");
    slot_->clientProcess.store(processId(), std::memory_order_relaxed);
    slot_->wantsFrames.store(0, std::memory_order_relaxed);
    slot_->keyRestraint.store(restraint, std::memory_order_relaxed);
    if (keeps("keys stay held")) keys.restore(slot_->keys);
    faultPoint("slot filled");
    slot_->clientTag.store(tag_, std::memory_order_release);
    faultPoint("slot claimed");
    ring(block_->bell);
}

Attachment::~Attachment() {
    std::uint64_t own = tag_;
    slot_->clientTag.compare_exchange_strong(own, 0, std::memory_order_release, std::memory_order_relaxed);
    faultPoint("slot left");
    ring(block_->bell);
}

bool Attachment::accepted() const {
    const bool own = slot_->clientTag.load(std::memory_order_relaxed) == tag_;
    return (own || !keeps("a client sees that it was taken for dead")) &&
           slot_->droppedTag.load(std::memory_order_acquire) != tag_;
}

QueueResult Attachment::trySend(const std::vector<std::byte>& message) {
    const QueueResult result = sender_.trySend(message);
    faultPoint("command sent");
    if (result == QueueResult::Done) ring(block_->bell);
    return result;
}

RingResult Attachment::tryReceive(ReplyRecord& reply) {
    return served() ? replies_.read(slot_->replies, reply) : RingResult::Nothing;
}

std::uint64_t Attachment::taken() const {
    return served() ? slot_->taken.load(std::memory_order_acquire) : 0;
}

} // namespace ipc
