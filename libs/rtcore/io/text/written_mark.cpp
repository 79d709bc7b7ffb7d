#include "rtcore/io/text/written_mark.h"

#include "rtcore/platform/files.h"

#include <fmt/core.h>

#include <cstdint>
#include <system_error>

namespace rtcore {

namespace {

/// FNV-1a, 64 bits (Fowler, Noll, Vo).
std::uint64_t checksum(std::string_view text) {
    std::uint64_t hash = 0xCBF29CE484222325U;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
    return hash;
}

std::string markOf(std::string_view text) {
    return fmt::format("# written by rtsuite {:016x}: comments are not kept when it is saved again\n",
                       checksum(text));
}

} // namespace

std::string withWrittenMark(std::string_view text) { return markOf(text).append(text); }

bool hasWrittenMark(std::string_view text) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return false;
    return text.substr(0, end + 1) == markOf(text.substr(end + 1));
}

bool isWrittenByHand(const std::filesystem::path& path) {
    std::error_code none;
    if (!std::filesystem::exists(path, none)) return false;
    const FileBytes file = openFileBytes(path);
    return !hasWrittenMark({reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()});
}

} // namespace rtcore
