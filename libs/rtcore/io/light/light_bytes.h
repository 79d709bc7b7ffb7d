/// The bytes of files of indirect light (docs/formats.md, ".light"): a head, the records, the cells. All
/// numbers are little-endian.
#pragma once

#include "rtcore/gathering/indirect_state.h"
#include "rtcore/io/light/light_key.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// As that of .bsp files (bsp_layout.h).
inline constexpr std::array<std::uint8_t, 8> kLightMagic{0x89, 'R', 'T', 'L', '\r', '\n', 0x1A, '\n'};
/// Another one for each change of how light is learned, too: what was learned goes on as it would have.
inline constexpr std::uint32_t kLightVersion = 2;

struct LightHead {
    std::array<std::uint8_t, 8> magic = kLightMagic;
    std::uint32_t version = kLightVersion;
    std::uint32_t crc = 0;                 ///< CRC-32 of all bytes behind it
    std::uint64_t surfaces = 0, light = 0; ///< of LightKey
    std::uint32_t frame = 0, names = 0, guesses = 0;
    Colour guess;
    std::uint32_t records = 0, cells = 0;
};
inline constexpr std::size_t kLightHeadBytes = 64, kLightRecordBytes = 145, kLightCellBytes = 32;
/// Where what the checksum is of begins.
inline constexpr std::size_t kLightCrcFrom = 16;

/// The size of a file with such a head.
constexpr std::uint64_t sizeOf(const LightHead& head) {
    return kLightHeadBytes + head.records * kLightRecordBytes + head.cells * kLightCellBytes;
}

/// The bytes of a light that checkIndirectState() has nothing against.
std::vector<std::byte> lightBytes(const LightKey& key, const IndirectState& light);

/// Of kLightHeadBytes bytes.
LightHead lightHeadOf(std::span<const std::byte> bytes);
/// Of as many bytes behind the head as `head` tells; `bounds` are not among them.
IndirectState lightBehind(const LightHead& head, std::span<const std::byte> bytes, const Box3& bounds);

} // namespace rtcore
