#include "rtcore/io/text/text_file.h"

#include "rtcore/io/text/toml_guard.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"
#include "rtcore/platform/paths.h"
#include "rtcore/platform/sentence.h"

#include <array>
#include <cstdint>
#include <span>

namespace rtcore {

std::string readShortText(const std::filesystem::path& path) { return readTextFile(path, kMaxTomlBytes); }

void writeCheckedText(const std::filesystem::path& path, const std::string& text,
                      const std::function<void(std::string_view)>& check) {
    try {
        check(text);
    } catch (const FileError& error) {
        throw FileError(FailureKind::CannotWrite, path.string(),
                        say("not written, since it could not be read back: {0}", error.sentence()));
    }
    const std::array<std::span<const std::byte>, 1> pieces{std::as_bytes(std::span(text))};
    writeFileAtomically(path, pieces);
}

TextPosition positionAt(std::string_view text, std::size_t offset) {
    TextPosition position;
    const std::size_t begin = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    for (std::size_t i = begin; i < offset; ++i) {
        const bool continuation = (static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80U;
        if (text[i] == '\n') {
            position = {position.line + 1, 1};
        } else if (!continuation) {
            ++position.column;
        }
    }
    return position;
}

std::filesystem::path pathFromUtf8(std::string_view text) {
    return {std::u8string(text.begin(), text.end()), std::filesystem::path::generic_format};
}

std::string pathToUtf8(const std::filesystem::path& path) {
    const std::u8string text = path.generic_u8string();
    return {text.begin(), text.end()};
}

std::filesystem::path pathSeenFrom(const std::filesystem::path& folder, const std::filesystem::path& path) {
    if (path.empty()) return path;
    const std::filesystem::path whole = plainPath(path);
    // The folder of a file without one is the current folder.
    const std::filesystem::path from = folder.empty() ? std::filesystem::current_path() : plainPath(folder);
    std::filesystem::path relative = whole.lexically_relative(from);
    const bool below = !relative.empty() && *relative.begin() != ".." && relative != ".";
    return below ? relative : whole;
}

} // namespace rtcore
