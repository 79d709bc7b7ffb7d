/// Commands as bytes in a queue. What comes out of a queue is checked to the last field before it is used.
#pragma once

#include "ipc/layout/message_headers.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ipc {

struct Message {
    std::uint64_t sequence = 0;
    bool wantsAnswer = true;
    std::string text; ///< without NUL
};

/// `message.text` has at most kMaxCommandText bytes and no NUL (asserted, checked by the caller).
std::vector<std::byte> encode(const Message& message, std::uint64_t epoch);

/// False, and `message` untouched, unless the bytes are a whole message for this epoch that comes after
/// `lastSequence`.
bool decode(std::span<const std::byte> bytes, std::uint64_t epoch, std::uint64_t lastSequence,
            Message& message);

/// CRC-32 (IEEE 802.3, reflected), as zlib computes it; goes on from `start`.
std::uint32_t crc32(std::span<const std::byte> bytes, std::uint32_t start = 0);

} // namespace ipc
