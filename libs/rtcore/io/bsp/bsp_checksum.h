/// The two checksums of a .bsp file: CRC-32 as zip files and PNG use it.
#pragma once

#include "rtcore/io/bsp/bsp_layout.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace rtcore {

/// The CRC-32 of `bytes` that follow others whose CRC is `before`.
std::uint32_t crc32Of(std::span<const std::byte> bytes, std::uint32_t before = 0);

/// The CRC-32 of the head without its last field.
std::uint32_t headCrcOf(const BspHead& head);

} // namespace rtcore
