#include "rtcore/io/bsp/bsp_checksum.h"

#include <zlib.h>

namespace rtcore {

std::uint32_t crc32Of(std::span<const std::byte> bytes, std::uint32_t before) {
    // zlib takes a null pointer as "give me the start value".
    if (bytes.empty()) return before;
    const auto* first = reinterpret_cast<const Bytef*>(bytes.data());
    return static_cast<std::uint32_t>(::crc32_z(before, first, bytes.size()));
}

std::uint32_t headCrcOf(const BspHead& head) {
    return crc32Of(std::as_bytes(std::span(&head, 1)).first(offsetof(BspHead, headCrc)));
}

} // namespace rtcore
