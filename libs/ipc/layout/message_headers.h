/// A command in a queue, and a reply in a reply ring: a header, then text.
#pragma once

#include "ipc/layout/limits.h"

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace ipc {

inline constexpr std::uint32_t kMessageMagic = 0x43535452; ///< "RTSC"

struct MessageHeader {
    std::uint32_t magic;
    std::uint32_t textBytes;
    std::uint64_t epoch;       ///< of the server that it is meant for
    std::uint64_t sequence;    ///< counts up within a client
    std::uint32_t wantsAnswer; ///< 0 or 1
    std::uint32_t checksum;    ///< CRC-32 of the header with this field 0, then of the text
};
static_assert(sizeof(MessageHeader) == 32 && std::is_trivially_copyable_v<MessageHeader>);

inline constexpr std::size_t kMaxMessageBytes = sizeof(MessageHeader) + kMaxCommandText;

/// Followed by the text, by what programs read of it, and by zeros up to a multiple of 16.
struct ReplyHeader {
    std::uint64_t sequence; ///< of the command
    std::uint16_t code;     ///< 0 done, else failed, with the exit code that suits it: 1..255
    std::uint16_t detailBytes;
    std::uint32_t textBytes;
};
static_assert(sizeof(ReplyHeader) == 16 && sizeof(ReplyHeader) + kMaxAnswerText == kReplyBytes);

} // namespace ipc
