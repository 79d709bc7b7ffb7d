#include "rtcore/scene/name_words.h"

#include <cstddef>

namespace rtcore {

namespace {

/// The letters with a mark of these languages, by the second byte of their UTF-8, as plain ones; others stay.
char foldedLatin(unsigned char lead, unsigned char next) {
    const unsigned code = (lead & 0x1FU) << 6U | (next & 0x3FU);
    constexpr std::string_view kFrom =
        "\xE0\xE1\xE2\xE3\xE4\xE7\xE8\xE9\xEA\xEB\xEC\xED\xEE\xEF\xF1\xF2\xF3\xF4\xF5\xF6"
        "\xF9\xFA\xFB\xFC\xFD";
    constexpr std::string_view kTo = "aaaaaceeeeiiiinooooouuuuy";
    const unsigned lower = code >= 0xC0 && code <= 0xDE ? code + 0x20 : code;
    if (lower <= 0xFF) {
        const std::size_t at = kFrom.find(static_cast<char>(lower));
        if (at != std::string_view::npos) return kTo[at];
    }
    switch (code | 1U) { // Latin Extended-A has capitals before small letters, in pairs
    case 0x10D:
        return 'c';
    case 0x10F:
        return 'd';
    case 0x105:
        return 'a';
    case 0x107:
        return 'c';
    case 0x119:
        return 'e';
    case 0x11B:
        return 'e';
    case 0x159:
        return 'r';
    case 0x15B:
        return 's';
    case 0x161:
        return 's';
    case 0x165:
        return 't';
    case 0x16F:
        return 'u';
    default:
        break;
    }
    if (code == 0x141 || code == 0x142) return 'l';
    if (code == 0x143 || code == 0x144 || code == 0x147 || code == 0x148) return 'n';
    if (code >= 0x179 && code <= 0x17E) return 'z';
    return 0;
}

bool isUpper(char c) { return c >= 'A' && c <= 'Z'; }
bool isLower(char c) { return c >= 'a' && c <= 'z'; }

} // namespace

std::vector<std::string> nameWords(std::string_view name) {
    std::vector<std::string> words(1);
    char before = 0;
    for (std::size_t i = 0; i < name.size(); ++i) {
        char c = name[i];
        const auto lead = static_cast<unsigned char>(c);
        if (lead >= 0xC0 && lead < 0xE0 && i + 1 < name.size())
            c = foldedLatin(lead, static_cast<unsigned char>(name[++i]));
        const bool letter = isUpper(c) || isLower(c);
        if ((!letter || (isUpper(c) && isLower(before))) && !words.back().empty()) words.emplace_back();
        if (letter) words.back() += static_cast<char>(isUpper(c) ? c - 'A' + 'a' : c);
        before = c;
    }
    return words;
}

} // namespace rtcore
