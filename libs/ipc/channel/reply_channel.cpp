#include "ipc/channel/reply_channel.h"

#include "ipc/channel/shared_copy.h"
#include "ipc/platform/fault_point.h"

#include <algorithm>

namespace ipc {

namespace {

constexpr std::size_t alignedBytes(std::size_t bytes) { return (bytes + 15) / 16 * 16; }

// `position` counts on for ever; the bytes wrap around.
void put(ReplyRing& ring, std::uint64_t position, const void* from, std::size_t bytes) {
    const std::size_t start = position % kReplyBytes;
    const std::size_t first = std::min(bytes, kReplyBytes - start);
    copyToShared(ring.bytes + start, from, first);
    copyToShared(ring.bytes, static_cast<const char*>(from) + first, bytes - first);
}

void get(const ReplyRing& ring, std::uint64_t position, void* to, std::size_t bytes) {
    const std::size_t start = position % kReplyBytes;
    const std::size_t first = std::min(bytes, kReplyBytes - start);
    copyFromShared(to, ring.bytes + start, first);
    copyFromShared(static_cast<char*>(to) + first, ring.bytes, bytes - first);
}

} // namespace

void ReplyWriter::reset(ReplyRing& ring) {
    head_ = 0;
    ring.head.store(0, std::memory_order_relaxed);
    ring.tail.store(0, std::memory_order_relaxed);
}

RingResult ReplyWriter::write(ReplyRing& ring, const ReplyRecord& reply) {
    const std::uint64_t used = head_ - ring.tail.load(std::memory_order_acquire);
    if (used > kReplyBytes) return RingResult::Broken;
    const std::string &text = reply.text, &detail = reply.detail;
    const std::size_t need = sizeof(ReplyHeader) + alignedBytes(text.size() + detail.size());
    if (need > kReplyBytes - used) return RingResult::Nothing;
    const ReplyHeader header{reply.sequence, reply.code, static_cast<std::uint16_t>(detail.size()),
                             static_cast<std::uint32_t>(text.size())};
    put(ring, head_, &header, sizeof(header));
    put(ring, head_ + sizeof(header), text.data(), text.size());
    put(ring, head_ + sizeof(header) + text.size(), detail.data(), detail.size());
    faultPoint("reply written");
    head_ += need;
    ring.head.store(head_, std::memory_order_release);
    return RingResult::Done;
}

RingResult ReplyReader::read(ReplyRing& ring, ReplyRecord& reply) {
    const std::uint64_t used = ring.head.load(std::memory_order_acquire) - tail_;
    if (used == 0) return RingResult::Nothing;
    ReplyHeader header;
    if (used > kReplyBytes || used < sizeof(header)) return RingResult::Broken;
    get(ring, tail_, &header, sizeof(header));
    if (header.textBytes > kMaxAnswerText) return RingResult::Broken;
    const std::size_t bytes =
        sizeof(header) + alignedBytes(std::size_t{header.textBytes} + header.detailBytes);
    if (bytes > used) return RingResult::Broken;
    reply.sequence = header.sequence;
    reply.code = header.code;
    reply.text.resize(header.textBytes);
    get(ring, tail_ + sizeof(header), reply.text.data(), reply.text.size());
    reply.detail.resize(header.detailBytes);
    get(ring, tail_ + sizeof(header) + reply.text.size(), reply.detail.data(), reply.detail.size());
    tail_ += bytes;
    ring.tail.store(tail_, std::memory_order_release);
    return RingResult::Done;
}

} // namespace ipc
