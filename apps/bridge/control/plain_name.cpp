#include "bridge/control/plain_name.h"

#include <cstddef>

namespace bridge {

namespace {

/// C1 controls, and marks that turn the direction of what follows: U+0080 to U+009F, U+202A to U+202E, U+2066
/// to U+2069.
bool isControl(std::string_view text) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
    };
    if (byte(0) < 0x20 || byte(0) == 0x7F) return true;
    if (byte(0) == 0xC2) return byte(1) >= 0x80 && byte(1) <= 0x9F;
    if (byte(0) != 0xE2) return false;
    return (byte(1) == 0x80 && byte(2) >= 0xAA && byte(2) <= 0xAE) ||
           (byte(1) == 0x81 && byte(2) >= 0xA6 && byte(2) <= 0xA9);
}

} // namespace

std::string plainName(std::string_view given) {
    constexpr std::size_t kMost = 40;
    const auto starts = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
    std::string name;
    std::size_t characters = 0;
    bool skips = false;
    for (std::size_t i = 0; i < given.size(); ++i) {
        if (starts(given[i])) {
            skips = isControl(given.substr(i));
            if (!skips && ++characters > kMost) break;
        }
        if (!skips) name += given[i];
    }
    return name;
}

} // namespace bridge
