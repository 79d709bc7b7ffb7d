#include "rtcore/io/text/pattern.h"

namespace rtcore {

namespace {

/// The character after the one that starts at `at`.
std::size_t nextCharacter(std::string_view text, std::size_t at) {
    ++at;
    while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U) ++at;
    return at;
}

} // namespace

bool matchesPattern(std::string_view pattern, std::string_view name) {
    constexpr auto none = std::string_view::npos;
    std::size_t p = 0, n = 0;
    // Only the last star needs to be tried again with more characters: what an earlier one would take in
    // addition, the last one can take as well.
    std::size_t lastStar = none, starTakesTo = 0;
    while (n < name.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            lastStar = p++;
            starTakesTo = n;
        } else if (p < pattern.size() && pattern[p] == '?') {
            ++p;
            n = nextCharacter(name, n);
        } else if (p < pattern.size() && pattern[p] == name[n]) {
            ++p;
            ++n;
        } else if (lastStar != none) {
            p = lastStar + 1;
            starTakesTo = nextCharacter(name, starTakesTo);
            n = starTakesTo;
        } else {
            return false;
        }
    }
    while (p < pattern.size() && pattern[p] == '*') ++p;
    return p == pattern.size();
}

} // namespace rtcore
