#include "rtcore/settings/plain_text.h"

#include "rtcore/settings/utf8.h"

#include <algorithm>

namespace rtcore {

namespace {

constexpr std::size_t kLongestQuoted = 64;

/// The code point of a well-formed character of at most three bytes; all controls are that short.
unsigned codePointOf(std::string_view character) {
    const auto bits = [&](std::size_t i, unsigned mask) {
        return static_cast<unsigned>(static_cast<unsigned char>(character[i])) & mask;
    };
    if (character.size() == 1) return bits(0, 0x7F);
    if (character.size() == 2) return bits(0, 0x1F) << 6U | bits(1, 0x3F);
    return bits(0, 0x0F) << 12U | bits(1, 0x3F) << 6U | bits(2, 0x3F);
}

/// Takes the next character off `text`, or one byte where none is well-formed: then `isText` is false, as
/// with a control.
std::string_view takeCharacter(std::string_view& text, bool& isText) {
    const std::size_t length = utf8Length(text);
    const std::string_view character = text.substr(0, std::max<std::size_t>(length, 1));
    text.remove_prefix(character.size());
    isText = length > 0 && !controlCode(character);
    return character;
}

} // namespace

std::optional<unsigned> controlCode(std::string_view character) {
    if (character.size() > 3) return std::nullopt;
    const unsigned point = codePointOf(character);
    const auto within = [point](unsigned first, unsigned last) { return point >= first && point <= last; };
    const bool control = point < 0x20 || within(0x7F, 0x9F) || point == 0x061C || within(0x200E, 0x200F) ||
                         within(0x2028, 0x202E) || within(0x2066, 0x2069);
    return control ? std::optional(point) : std::nullopt;
}

std::string printable(std::string_view text, std::size_t limit) {
    constexpr std::string_view digits = "0123456789abcdef";
    const bool shortened = text.size() > limit;
    if (shortened) text = utf8Beginning(text, limit);
    std::string result;
    while (!text.empty()) {
        bool isText = false;
        const std::string_view character = takeCharacter(text, isText);
        if (isText) {
            result += character;
            continue;
        }
        for (const char c : character) {
            const auto byte = static_cast<unsigned char>(c);
            result += {'\\', 'x', digits[byte >> 4U], digits[byte & 15U]};
        }
    }
    return shortened ? result + "..." : result;
}

std::string inQuotes(std::string_view text) { return "'" + printable(text, kLongestQuoted) + "'"; }

std::string withoutControls(std::string_view text, std::size_t max) {
    std::string result;
    for (std::size_t count = 0; !text.empty() && count < max;) {
        bool isText = false;
        const std::string_view character = takeCharacter(text, isText);
        if (!isText) continue;
        result += character;
        ++count;
    }
    return result;
}

} // namespace rtcore
