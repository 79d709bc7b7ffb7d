#include "bridge/control/plain_name.h"

#include <cstddef>

namespace bridge {

std::string plainName(std::string_view given) {
    constexpr std::size_t kMost = 40;
    const auto starts = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
    std::string name;
    std::size_t characters = 0;
    for (const char c : given) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7F) continue;
        if (starts(c) && ++characters > kMost) break;
        name += c;
    }
    return name;
}

} // namespace bridge
