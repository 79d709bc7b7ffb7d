/// Numbers as binary PLY files store them.
#pragma once

#include "rtcore/io/import/scan/ply_header.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace rtcore {

/// `swapped`: the file's bytes are in the other order than the machine's.
template <typename T>
T plyNumber(const std::byte* at, bool swapped) {
    std::array<std::byte, sizeof(T)> bytes;
    std::memcpy(bytes.data(), at, sizeof(T));
    if (swapped) std::reverse(bytes.begin(), bytes.end());
    return std::bit_cast<T>(bytes);
}

/// Calls `use` with a value of the C++ type; returns what it returns.
template <typename Use>
auto withPlyType(PlyType type, const Use& use) {
    switch (type) {
    case PlyType::Int8:
        return use(std::int8_t{});
    case PlyType::UInt8:
        return use(std::uint8_t{});
    case PlyType::Int16:
        return use(std::int16_t{});
    case PlyType::UInt16:
        return use(std::uint16_t{});
    case PlyType::Int32:
        return use(std::int32_t{});
    case PlyType::UInt32:
        return use(std::uint32_t{});
    case PlyType::Float32:
        return use(float{});
    case PlyType::Float64:
        break;
    }
    return use(double{});
}

/// A part of a colour as a fraction of 1: of a floating point number itself, of integers by their range, as
/// Assimp has it.
template <typename T>
float fractionOf(T value) {
    constexpr float kByte = 0xFF;
    constexpr float kWord = 0xFFFF;
    if constexpr (std::is_floating_point_v<T>) {
        return static_cast<float>(value);
    } else if constexpr (std::is_same_v<T, std::int8_t>) {
        return static_cast<float>(value + 0xFF / 2) / kByte;
    } else if constexpr (std::is_same_v<T, std::int16_t>) {
        return static_cast<float>(value + 0xFFFF / 2) / kWord;
    } else if constexpr (std::is_same_v<T, std::int32_t>) {
        return static_cast<float>(value) / kByte + 0.5F;
    } else {
        return static_cast<float>(value) / (sizeof(T) == 1 ? kByte : kWord);
    }
}

} // namespace rtcore
