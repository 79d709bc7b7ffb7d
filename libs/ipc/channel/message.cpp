#include "ipc/channel/message.h"
#include "ipc/platform/rules.h"

#include <array>
#include <cassert>
#include <cstring>

namespace ipc {

namespace {

constexpr std::array<std::uint32_t, 256> crcTable() {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        std::uint32_t rest = byte;
        for (int bit = 0; bit < 8; ++bit) rest = (rest >> 1) ^ ((rest & 1) != 0 ? 0xEDB88320u : 0u);
        table[byte] = rest;
    }
    return table;
}
constexpr auto kCrcTable = crcTable();

std::uint32_t checksum(MessageHeader header, std::span<const std::byte> text) {
    header.checksum = 0;
    return crc32(text, crc32(std::as_bytes(std::span(&header, 1))));
}

} // namespace

std::uint32_t crc32(std::span<const std::byte> bytes, std::uint32_t start) {
    std::uint32_t crc = ~start;
    for (const std::byte byte : bytes) {
        crc = kCrcTable[(crc ^ std::to_integer<std::uint32_t>(byte)) & 0xFF] ^ (crc >> 8);
    }
    return ~crc;
}

std::vector<std::byte> encode(const Message& message, std::uint64_t epoch) {
    assert(message.text.size() <= kMaxCommandText);
    MessageHeader header{.magic = kMessageMagic,
                         .textBytes = static_cast<std::uint32_t>(message.text.size()),
                         .epoch = epoch,
                         .sequence = message.sequence,
                         .wantsAnswer = message.wantsAnswer ? 1u : 0u,
                         .checksum = 0};
    const auto text = std::as_bytes(std::span(message.text));
    header.checksum = checksum(header, text);
    std::vector<std::byte> bytes(sizeof(header) + text.size());
    std::memcpy(bytes.data(), &header, sizeof(header));
    if (!text.empty()) std::memcpy(bytes.data() + sizeof(header), text.data(), text.size());
    return bytes;
}

bool decode(std::span<const std::byte> bytes, std::uint64_t epoch, std::uint64_t lastSequence,
            Message& message) {
    MessageHeader header;
    if (bytes.size() < sizeof(header)) return false;
    std::memcpy(&header, bytes.data(), sizeof(header));
    const auto text = bytes.subspan(sizeof(header));
    if (header.magic != kMessageMagic || header.textBytes != text.size() || text.size() > kMaxCommandText ||
        (header.epoch != epoch && keeps("messages are of this epoch")) || header.sequence <= lastSequence ||
        header.wantsAnswer > 1) {
        return false;
    }
    if (checksum(header, text) != header.checksum && keeps("checksums are compared")) return false;
    if (!text.empty() && std::memchr(text.data(), 0, text.size()) != nullptr) return false;
    message = {.sequence = header.sequence,
               .wantsAnswer = header.wantsAnswer == 1,
               .text = std::string(reinterpret_cast<const char*>(text.data()), text.size())};
    return true;
}

} // namespace ipc
