#include "rtcore/io/loading/file_kind.h"

#include "rtcore/io/bsp/bsp_file.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string_view>

namespace rtcore {

namespace {

/// A .scn is text in which some line sets `version`; other programs' .scn files are not. Nor is XML, where an
/// attribute `version` may stand at the beginning of a line.
bool isSceneText(std::string_view head) {
    if (head.find('\0') != std::string_view::npos) return false;
    const std::size_t text = head.find_first_not_of("\xEF\xBB\xBF \t\r\n");
    if (text != std::string_view::npos && head[text] == '<') return false;
    while (!head.empty()) {
        const std::size_t end = std::min(head.find('\n'), head.size());
        std::string_view line = head.substr(0, end);
        head.remove_prefix(std::min(end + 1, head.size()));
        if (line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
        line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
        if (!line.starts_with("version")) continue;
        line.remove_prefix(std::string_view("version").size());
        line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
        if (line.starts_with("=")) return true;
    }
    return false;
}

} // namespace

FileKind kindOfFile(const std::filesystem::path& path, InputFile& file) {
    constexpr std::size_t kHead = 65536;
    const std::span<const std::byte> bytes = file.head(kHead);
    if (isBsp(bytes)) return FileKind::Bsp;
    const std::string_view head(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const bool text = head.find('\0') == std::string_view::npos && !head.starts_with("Caligari");
    if (isSceneText(head) || (path.extension() == ".scn" && text)) return FileKind::Scene;
    return FileKind::Model;
}

} // namespace rtcore
