#include "rtcore/io/text/text_file.h"

#include "rtcore/io/text/toml_guard.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"

#include <array>
#include <cstdint>
#include <span>

namespace rtcore {

namespace {

struct Utf8Form {
    std::size_t length;            ///< bytes
    unsigned char lowest, highest; ///< of the second byte; the others are 80..BF
};

/// What may follow a first byte; length 0 when nothing may.
Utf8Form utf8Form(unsigned char first) {
    if (first < 0x80) return {1, 0, 0};
    if (first < 0xC2 || first > 0xF4) return {0, 0, 0};
    if (first < 0xE0) return {2, 0x80, 0xBF};
    if (first == 0xE0) return {3, 0xA0, 0xBF};
    if (first == 0xED) return {3, 0x80, 0x9F};
    if (first < 0xF0) return {3, 0x80, 0xBF};
    if (first == 0xF0) return {4, 0x90, 0xBF};
    return first == 0xF4 ? Utf8Form{4, 0x80, 0x8F} : Utf8Form{4, 0x80, 0xBF};
}

bool startsWithUtf8(std::string_view text, const Utf8Form& form) {
    if (form.length == 0 || form.length > text.size()) return false;
    for (std::size_t i = 1; i < form.length; ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const unsigned char lowest = i == 1 ? form.lowest : 0x80, highest = i == 1 ? form.highest : 0xBF;
        if (byte < lowest || byte > highest) return false;
    }
    return true;
}

} // namespace

std::string readShortText(const std::filesystem::path& path) { return readTextFile(path, kMaxTomlBytes); }

void writeCheckedText(const std::filesystem::path& path, const std::string& text,
                      const std::function<void(std::string_view)>& check) {
    try {
        check(text);
    } catch (const FileError& error) {
        throw FileError(FailureKind::CannotWrite, path.string(),
                        "not written, since it could not be read back: " + std::string(error.what()));
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

std::size_t findInvalidUtf8(std::string_view text) {
    std::size_t at = 0;
    while (at < text.size()) {
        const Utf8Form form = utf8Form(static_cast<unsigned char>(text[at]));
        if (!startsWithUtf8(text.substr(at), form)) return at;
        at += form.length;
    }
    return std::string_view::npos;
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
    const auto absolute = [](const std::filesystem::path& p) {
        return std::filesystem::absolute(p).lexically_normal();
    };
    const std::filesystem::path whole = absolute(path);
    // The folder of a file without one is the current folder.
    const std::filesystem::path from = folder.empty() ? std::filesystem::current_path() : absolute(folder);
    std::filesystem::path relative = whole.lexically_relative(from);
    const bool below = !relative.empty() && *relative.begin() != ".." && relative != ".";
    return below ? relative : whole;
}

} // namespace rtcore
