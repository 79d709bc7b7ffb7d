#include "bridge/stream/wire.h"

#include <algorithm>
#include <type_traits>

namespace bridge {

namespace {

enum ClientType : std::uint8_t { kAck = 1, kInput = 2, kView = 3, kPartAck = 4, kPing = 5 };
enum BridgeType : std::uint8_t { kFrameMessage = 1, kPartMessage = 2, kEchoMessage = 3 };
enum HeaderFlag : std::uint16_t { kKeyFrame = 1, kExact = 2, kLastPart = 4 };

constexpr std::size_t kAckBytes = 16, kInputBytes = 16, kViewBytes = 8, kPingBytes = 16;
constexpr std::size_t kMaxHeld = 16, kMaxTaps = 8;
constexpr int kMaxTurn = 360'000;
constexpr std::uint8_t kAutomatic = 255;

template <typename Number>
Number get(std::span<const std::uint8_t> bytes, std::size_t at) {
    std::make_unsigned_t<Number> value = 0;
    for (std::size_t i = sizeof(Number); i-- > 0;)
        value = static_cast<std::make_unsigned_t<Number>>(value << 8 | bytes[at + i]);
    return static_cast<Number>(value);
}

template <typename Number>
void put(Header& header, std::size_t at, Number value) {
    for (std::size_t i = 0; i < sizeof(Number); ++i)
        header[at + i] = static_cast<std::uint8_t>(value >> (8 * i));
}

std::uint32_t bytesOf(std::size_t size) { return static_cast<std::uint32_t>(size); }

std::optional<ClientMessage> parseAck(std::span<const std::uint8_t> bytes) {
    if (bytes.size() != kAckBytes) return {};
    constexpr double kUnit = 1e-4;
    return AckMessage{bytes[0] == kPartAck, get<std::uint16_t>(bytes, 2) * kUnit,
                      get<std::uint32_t>(bytes, 4), get<std::uint64_t>(bytes, 8)};
}

std::optional<ClientMessage> parseInput(std::span<const std::uint8_t> bytes) {
    if (bytes.size() < kInputBytes) return {};
    const std::size_t held = bytes[1], taps = bytes[2];
    if (held > kMaxHeld || taps > kMaxTaps || bytes.size() != kInputBytes + held + taps) return {};
    InputMessage input;
    input.sequence = get<std::uint32_t>(bytes, 4);
    input.right = get<std::int32_t>(bytes, 8);
    input.up = get<std::int32_t>(bytes, 12);
    if (std::max(input.right, input.up) > kMaxTurn || std::min(input.right, input.up) < -kMaxTurn) return {};
    const auto keys = bytes.subspan(kInputBytes);
    input.held.assign(keys.begin(), keys.begin() + static_cast<std::ptrdiff_t>(held));
    input.taps.assign(keys.begin() + static_cast<std::ptrdiff_t>(held), keys.end());
    return input;
}

std::optional<ClientMessage> parseView(std::span<const std::uint8_t> bytes) {
    if (bytes.size() != kViewBytes) return {};
    if (bytes[1] > 1 || (bytes[2] >= kRungCount && bytes[2] != kAutomatic)) return {};
    PageView view;
    view.visible = bytes[1] == 1;
    if (bytes[2] != kAutomatic) view.rung = bytes[2];
    view.saveData = (bytes[3] & 1) != 0;
    view.noStill = (bytes[3] & 2) != 0;
    view.width = get<std::uint16_t>(bytes, 4);
    view.height = get<std::uint16_t>(bytes, 6);
    return view;
}

} // namespace

Header headerOf(const Shipment& shipment, std::uint32_t input, std::uint32_t ageMicroseconds) {
    const EncodedFrame& frame = *shipment.frame;
    Header header{};
    const bool last = shipment.part && shipment.offset + shipment.size == frame.bytes.size();
    header[0] = shipment.part ? kPartMessage : kFrameMessage;
    header[1] = static_cast<std::uint8_t>(frame.codec);
    put<std::uint16_t>(
        header, 2,
        static_cast<std::uint16_t>(kKeyFrame | (frame.exact ? kExact : 0) | (last ? kLastPart : 0)));
    put(header, 4, frame.facts.stream);
    put(header, 8, frame.facts.number);
    put(header, 16, frame.facts.width);
    put(header, 18, frame.facts.height);
    put(header, 20, frame.facts.shownWidth);
    put(header, 22, frame.facts.shownHeight);
    put(header, 24, input);
    put(header, 28, ageMicroseconds);
    put(header, 32, bytesOf(shipment.offset));
    put(header, 36, bytesOf(frame.bytes.size()));
    return header;
}

Header echoHeader(std::uint64_t stamp) {
    Header header{};
    header[0] = kEchoMessage;
    put(header, 8, stamp);
    return header;
}

std::optional<ClientMessage> parseClientMessage(std::span<const std::uint8_t> bytes) {
    if (bytes.empty()) return {};
    switch (bytes[0]) {
    case kAck:
    case kPartAck:
        return parseAck(bytes);
    case kInput:
        return parseInput(bytes);
    case kView:
        return parseView(bytes);
    case kPing:
        if (bytes.size() != kPingBytes) return {};
        return PingMessage{get<std::uint64_t>(bytes, 8)};
    default:
        return {};
    }
}

} // namespace bridge
