#include "rtcore/io/bsp/bsp_checksum.h"

#include "rtcore/io/bsp/crc_folding.h"
#include "rtcore/platform/threads.h"

#include <zlib.h>

#include <vector>

namespace rtcore {

namespace {

uLong crcOf(std::span<const std::byte> bytes) {
    constexpr std::size_t kStep = 64, kWorthFolding = 4 * kStep;
    const std::size_t folded = bytes.size() < kWorthFolding ? 0 : bytes.size() / kStep * kStep;
    const uLong crc = folded > 0 ? foldedCrc(bytes.first(folded), 0) : 0;
    const std::span<const std::byte> rest = bytes.subspan(folded);
    return ::crc32_z(crc, reinterpret_cast<const Bytef*>(rest.data()), rest.size());
}

} // namespace

std::uint32_t crc32Of(std::span<const std::byte> bytes, std::uint32_t before) {
    // Parts of it by several threads; crc32_combine() takes no longer for long ones.
    constexpr std::size_t kWorthThreads = std::size_t{4} << 20;
    const auto parts = static_cast<std::size_t>(bytes.size() < kWorthThreads ? 1 : threadsFor(0));
    const auto begin = [&](std::size_t part) { return bytes.size() / parts * part; };
    const auto end = [&](std::size_t part) { return part + 1 < parts ? begin(part + 1) : bytes.size(); };
    std::vector<uLong> crcs(parts);
#pragma omp parallel for schedule(static, 1) if (parts > 1)
    for (std::size_t part = 0; part < parts; ++part) {
        const std::span<const std::byte> own = bytes.subspan(begin(part), end(part) - begin(part));
        // zlib takes a null pointer as "give me the start value".
        if (!own.empty()) crcs[part] = crcOf(own);
    }
    uLong crc = before;
    for (std::size_t part = 0; part < parts; ++part)
        crc = ::crc32_combine(crc, crcs[part], static_cast<z_off_t>(end(part) - begin(part)));
    return static_cast<std::uint32_t>(crc);
}

std::uint32_t headCrcOf(const BspHead& head) {
    return crc32Of(std::as_bytes(std::span(&head, 1)).first(offsetof(BspHead, headCrc)));
}

} // namespace rtcore
