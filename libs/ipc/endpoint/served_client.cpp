#include "ipc/endpoint/served_client.h"

#include "ipc/channel/message.h"
#include "ipc/channel/shared_copy.h"
#include "ipc/platform/fault_point.h"

#include <algorithm>

namespace ipc {

namespace {

constexpr int kMaxUnanswered = 64;
constexpr int kMaxMalformedPerSecond = 100;

} // namespace

bool ServedClient::look(int index, ClientSlot& slot, const Names& names, std::uint64_t epoch,
                        std::vector<Command>& commands) {
    const std::uint64_t tag = slot.clientTag.load(std::memory_order_acquire);
    if (tag == tag_ || (tag != 0 && tag == dropped_)) return false;
    if (active()) leave(slot, epoch, commands);
    if (tag != 0) adopt(index, slot, names, tag);
    return true;
}

void ServedClient::repair(ClientSlot& slot) const {
    keep(slot.droppedTag, dropped_);
    keep(slot.servedTag, tag_);
    if (active()) keep(slot.taken, lastSequence_);
}

void ServedClient::declareDead(ClientSlot& slot, std::uint64_t tag) {
    faultPoint("client found dead");
    // A successor may have put its own tag there meanwhile.
    slot.clientTag.compare_exchange_strong(tag, 0, std::memory_order_acq_rel, std::memory_order_relaxed);
}

void ServedClient::adopt(int index, ClientSlot& slot, const Names& names, std::uint64_t tag) {
    index_ = index;
    tag_ = tag;
    lastSequence_ = 0;
    unanswered_ = 0;
    waiting_.clear();
    keys_ = {};
    restraint_ = slot.keyRestraint.load(std::memory_order_relaxed);
    inWindow_ = 0;
    slot.taken.store(0, std::memory_order_relaxed);
    slot.malformed.store(0, std::memory_order_relaxed);
    slot.repliesWait.store(0, std::memory_order_relaxed);
    replies_.reset(slot.replies);
    if (CommandReceiver::open(names.queue(index, tag), queue_) != QueueResult::Done) {
        return drop(slot, DropReason::NoQueue);
    }
    faultPoint("client adopted");
    slot.servedTag.store(tag, std::memory_order_release);
    ring(slot.bell);
}

void ServedClient::drop(ClientSlot& slot, DropReason reason) {
    slot.dropReason.store(reason, std::memory_order_relaxed);
    dropped_ = tag_;
    slot.droppedTag.store(tag_, std::memory_order_release);
    slot.servedTag.store(0, std::memory_order_release);
    tag_ = 0;
    queue_ = {};
    waiting_.clear();
    ring(slot.bell);
}

void ServedClient::leave(ClientSlot& slot, std::uint64_t epoch, std::vector<Command>& commands) {
    const std::size_t before = commands.size();
    for (std::size_t i = 0; active() && i < 2 * kCommandQueueLength; ++i) {
        if (takeOne(slot, epoch, commands) == QueueResult::Nothing) break;
    }
    for (std::size_t i = before; i < commands.size(); ++i) commands[i].wantsAnswer = false;
    slot.servedTag.store(0, std::memory_order_release);
    tag_ = 0;
    queue_ = {};
}

void ServedClient::serve(ClientSlot& slot, std::uint64_t epoch, int limit, std::vector<Command>& commands) {
    if (!sendWaiting(slot)) return;
    for (int i = 0; active() && i < limit && unanswered_ < kMaxUnanswered; ++i) {
        if (takeOne(slot, epoch, commands) == QueueResult::Nothing) return;
    }
}

// Drops the client when the queue is broken.
QueueResult ServedClient::takeOne(ClientSlot& slot, std::uint64_t epoch, std::vector<Command>& commands) {
    const QueueResult result = queue_.tryReceive(buffer_);
    if (result == QueueResult::Broken) drop(slot, DropReason::BrokenQueue);
    if (result != QueueResult::Done) return result;
    Message message;
    if (!decode(buffer_, epoch, lastSequence_, message)) {
        slot.malformed.store(++malformed_, std::memory_order_relaxed);
        if (tooManyMalformed()) drop(slot, DropReason::Malformed);
        return result;
    }
    faultPoint("command taken");
    lastSequence_ = message.sequence;
    if (message.wantsAnswer) ++unanswered_;
    slot.taken.store(message.sequence, std::memory_order_release);
    commands.push_back({index_, tag_, message.sequence, message.wantsAnswer, std::move(message.text)});
    return result;
}

bool ServedClient::tooManyMalformed() {
    const Clock::time_point now = Clock::now();
    if (now - windowStart_ > std::chrono::seconds(1)) {
        windowStart_ = now;
        inWindow_ = 0;
    }
    return ++inWindow_ > kMaxMalformedPerSecond;
}

void ServedClient::answer(ClientSlot& slot, const Command& command, ReplyRecord reply) {
    if (!command.wantsAnswer || command.client != tag_ || unanswered_ == 0) return;
    --unanswered_;
    reply.sequence = command.sequence;
    reply.text.resize(std::min(reply.text.size(), kMaxAnswerText));
    if (reply.text.size() + reply.detail.size() > kMaxAnswerText) reply.detail.clear();
    waiting_.push_back(std::move(reply));
    sendWaiting(slot);
}

// True when none waits any more.
bool ServedClient::sendWaiting(ClientSlot& slot) {
    bool sent = false;
    while (!waiting_.empty()) {
        const ReplyRecord& reply = waiting_.front();
        const RingResult result = replies_.write(slot.replies, reply);
        if (result == RingResult::Broken) {
            drop(slot, DropReason::BadReplies);
            return false;
        }
        if (result == RingResult::Nothing) break;
        waiting_.pop_front();
        sent = true;
    }
    slot.repliesWait.store(waiting_.empty() ? 0 : 1, std::memory_order_relaxed);
    if (sent) ring(slot.bell);
    return waiting_.empty();
}

} // namespace ipc
