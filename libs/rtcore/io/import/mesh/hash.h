/// Hashes of numbers, for tables that live as long as an import.
#pragma once

#include <bit>
#include <cstdint>

namespace rtcore {

inline std::uint64_t mixedHash(std::uint64_t hash, std::uint64_t value) {
    hash = (hash ^ value) * 0x9E3779B97F4A7C15ULL;
    return hash ^ (hash >> 32);
}
inline std::uint64_t bitsOfPair(float a, float b) {
    return (std::uint64_t{std::bit_cast<std::uint32_t>(a)} << 32) | std::bit_cast<std::uint32_t>(b);
}
inline std::uint64_t finishedHash(std::uint64_t hash) { return hash * 0xD6E8FEB86659FD93ULL ^ (hash >> 29); }

} // namespace rtcore
