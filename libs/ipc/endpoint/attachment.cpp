#include "ipc/endpoint/attachment.h"

#include "ipc/platform/error.h"
#include "ipc/platform/stage.h"

namespace ipc {

SlotLock SlotLock::take(const Names& names, const std::string& folder) {
    for (int slot = 0; slot < kMaxClients; ++slot) {
        std::optional<OwnerLock> lock = OwnerLock::tryTake(names.clientLock(folder, slot));
        if (!lock) continue;
        // Whoever made these had the lock, and is dead.
        for (const std::string& queue : segmentNames(names.queuePrefix(slot))) Segment::remove(queue);
        return {slot, folder, std::move(*lock)};
    }
    throw Error(Problem::NoSlot, "server '" + names.instance() + "' has " + std::to_string(kMaxClients) +
                                     " clients, and takes no more; end one");
}

Attachment::Attachment(const Names& names, const Link& link, const SlotLock& lock, const KeyWriter& keys)
    : block_(&link.block()), slot_(&block_->slots[lock.slot]), tag_(randomTag()),
      sender_(names.queue(lock.slot, tag_)) {
    stage("queue made");
    slot_->clientProcess.store(processId(), std::memory_order_relaxed);
    slot_->wantsFrames.store(0, std::memory_order_relaxed);
    keys.restore(slot_->keys);
    stage("slot filled");
    slot_->clientTag.store(tag_, std::memory_order_release);
    stage("slot claimed");
    ring(block_->bell);
}

Attachment::~Attachment() {
    std::uint64_t own = tag_;
    slot_->clientTag.compare_exchange_strong(own, 0, std::memory_order_release, std::memory_order_relaxed);
    stage("slot left");
    ring(block_->bell);
}

bool Attachment::accepted() const { return slot_->droppedTag.load(std::memory_order_acquire) != tag_; }

QueueResult Attachment::trySend(const std::vector<std::byte>& message) {
    const QueueResult result = sender_.trySend(message);
    stage("command sent");
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
