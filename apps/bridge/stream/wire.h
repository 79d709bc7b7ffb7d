/// The binary messages (docs/bridge.md), to bytes and back. Little-endian.
#pragma once

#include "bridge/stream/delivery.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace bridge {

/// Version of the messages of pages and bridge; `hello` names it. A page of another one has to be reloaded.
inline constexpr int kPageVersion = 2;

inline constexpr std::size_t kHeaderBytes = 40;
using Header = std::array<std::uint8_t, kHeaderBytes>;

/// `input`: sequence of the viewer's last input before the frame; `ageMicroseconds`: since it was published.
Header headerOf(const Shipment& shipment, std::uint32_t input, std::uint32_t ageMicroseconds);
Header echoHeader(std::uint64_t stamp);

struct AckMessage {
    bool part = false;
    double decodeSeconds = 0;
    std::uint32_t stream = 0;
    std::uint64_t number = 0;
};
struct InputMessage {
    std::uint32_t sequence = 0;
    int right = 0, up = 0; ///< 1/1000 degree
    std::vector<std::uint8_t> held, taps;
};
struct PingMessage {
    std::uint64_t stamp = 0;
};
using ClientMessage = std::variant<AckMessage, InputMessage, PageView, PingMessage>;

/// Nothing where it is none of these.
std::optional<ClientMessage> parseClientMessage(std::span<const std::uint8_t> bytes);

} // namespace bridge
