#include "rtcore/settings/utf8.h"

namespace rtcore {

namespace {

struct Utf8Form {
    std::size_t length;            ///< bytes
    unsigned char lowest, highest; ///< of the second byte; the others are 80..BF
};

/// The form of the sequences with this first byte; length 0 when there are none.
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

std::size_t utf8Length(std::string_view text) {
    if (text.empty()) return 0;
    const Utf8Form form = utf8Form(static_cast<unsigned char>(text[0]));
    return startsWithUtf8(text, form) ? form.length : 0;
}

std::size_t findInvalidUtf8(std::string_view text) {
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t length = utf8Length(text.substr(at));
        if (length == 0) return at;
        at += length;
    }
    return std::string_view::npos;
}

std::string_view utf8Beginning(std::string_view text, std::size_t max) {
    if (text.size() <= max) return text;
    std::size_t end = max;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end; // within a character
    return text.substr(0, end);
}

} // namespace rtcore
