#include "rtcore/io/import/text/statement_pieces.h"

#include "rtcore/io/import/text/statement_text.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

namespace rtcore {

namespace {

constexpr std::uint64_t kBytesAtOnce = std::uint64_t{4} << 20; // enough work for several threads
constexpr std::uint64_t kBytesBetweenSigns = std::uint64_t{64} << 20;

} // namespace

void forEachStatements(const InputFile& file, const std::function<void()>& alive, const UseStatements& use,
                       std::uint64_t from) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    const auto atOnce = static_cast<std::size_t>(std::min(kBytesAtOnce, file.size() + 1));
    std::vector<char> buffer(2 * atOnce + 1);
    std::size_t kept = 0; // bytes at its beginning that wait for the rest of their statement
    bool begun = false;
    for (std::uint64_t offset = from;;) {
        if (buffer.size() < kept + atOnce + 1) buffer.resize(2 * buffer.size());
        const std::span<char> room = std::span(buffer).subspan(kept);
        const std::size_t got = file.readAt(offset, std::as_writable_bytes(room.first(room.size() - 1)));
        const std::uint64_t told = offset / kBytesBetweenSigns;
        offset += got;
        std::size_t end = kept + got;
        if (got == 0) buffer[end++] = '\n';
        const std::string_view text(buffer.data(), end);
        const std::size_t whole = got == 0 ? end : wholeStatements(text);
        const std::size_t skipped = !begun && text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
        begun = begun || whole > 0;
        if (whole > 0) use(text.substr(skipped, whole - skipped), offset);
        if (got == 0) return;
        kept = end - whole;
        std::memmove(buffer.data(), buffer.data() + whole, kept);
        if (offset / kBytesBetweenSigns != told) alive();
    }
}

} // namespace rtcore
