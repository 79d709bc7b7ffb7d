#include "ipc/channel/queue_check.h"

#include "ipc/layout/message_headers.h"
#include "ipc/platform/boost_interprocess.h"

#include <boost/interprocess/ipc/message_queue.hpp>

#include <cstring>

namespace ipc {

namespace {

namespace bi = boost::interprocess;

// As Boost lays them out, one after the other: a word that tells whether the segment is initialised, this
// header, an index of pointers, the messages.
using Header = bi::ipcdetail::mq_hdr_t<bi::offset_ptr<void>>;
using Message = bi::ipcdetail::msg_hdr_t<bi::offset_ptr<void>>;
using MessagePointer = bi::offset_ptr<Message>;
constexpr std::size_t kHeaderOffset =
    bi::ipcdetail::managed_open_or_create_impl<bi::shared_memory_object, 0, true,
                                               false>::ManagedOpenOrCreateUserOffset;
constexpr std::uint32_t kInitialised = 2;

bool soundCounts(const Header& header) {
    // No process waits inside a queue. A count may be at its limit for a moment while the other side changes
    // it.
    return header.m_max_num_msg == kCommandQueueLength && header.m_max_msg_size == kMaxMessageBytes &&
           header.m_cur_num_msg <= kCommandQueueLength && header.m_cur_first_msg <= kCommandQueueLength &&
           header.m_blocked_senders == 0 && header.m_blocked_receivers == 0;
}

bool soundIndex(const Header& header, const std::byte* end) {
    const auto* index = reinterpret_cast<const MessagePointer*>(&header + 1);
    if (reinterpret_cast<const MessagePointer*>(header.mp_index.get()) != index) return false;
    const auto* messages = reinterpret_cast<const std::byte*>(index + kCommandQueueLength);
    const std::size_t stride = static_cast<std::size_t>(end - messages) / kCommandQueueLength;
    for (std::size_t i = 0; i < kCommandQueueLength; ++i) {
        const Message* message = index[i].get();
        const auto offset =
            reinterpret_cast<std::uintptr_t>(message) - reinterpret_cast<std::uintptr_t>(messages);
        if (offset % stride != 0 || offset / stride >= kCommandQueueLength) return false;
        if (message->len > kMaxMessageBytes) return false;
    }
    return true;
}

} // namespace

bool isSoundQueue(const Segment& memory) {
    if (memory.bytes() != Header::get_mem_size(kMaxMessageBytes, kCommandQueueLength)) return false;
    const auto* bytes = static_cast<const std::byte*>(memory.data());
    std::uint32_t word = 0;
    std::memcpy(&word, bytes, sizeof word);
    const Header& header = *reinterpret_cast<const Header*>(bytes + kHeaderOffset);
    return word == kInitialised && soundCounts(header) && soundIndex(header, bytes + memory.bytes());
}

} // namespace ipc
