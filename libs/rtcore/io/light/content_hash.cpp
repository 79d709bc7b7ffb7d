#include "rtcore/io/light/content_hash.h"

#include "rtcore/irradiance/hashed_cell.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace rtcore {

namespace {

using Block = std::array<std::uint64_t, 4>;

/// A step of xxHash, for each of four words. (Collet 2012)
void mix(Block& state, const Block& words) {
    for (std::size_t i = 0; i < state.size(); ++i)
        state[i] = std::rotl(state[i] + words[i] * 0xC2B2AE3D27D4EB4FU, 31) * 0x9E3779B185EBCA87U;
}

} // namespace

void ContentHash::add(std::span<const std::byte> bytes) {
    Block state{value_, bytes.size(), 1, 2};
    while (!bytes.empty()) {
        Block words{};
        const std::size_t size = std::min(bytes.size(), sizeof words);
        std::memcpy(words.data(), bytes.data(), size);
        mix(state, words);
        bytes = bytes.subspan(size);
    }
    value_ = 0;
    for (const std::uint64_t each : state) value_ = hashOfCell(value_ + each);
}

} // namespace rtcore
