#include "rtcore/io/import/obj/map_statement.h"

#include "rtcore/io/import/text/statement_text.h"

#include <algorithm>
#include <array>

namespace rtcore {

namespace {

using View = std::string_view;

/// An option and the words behind it; of numbers, all but the first may be left out.
struct Option {
    View name;
    int words;
    bool numbers = false;
};
constexpr std::array kOptions{Option{"-s", 3, true},  Option{"-o", 3, true},   Option{"-t", 3, true},
                              Option{"-mm", 2, true}, Option{"-bm", 1},        Option{"-clamp", 1},
                              Option{"-blendu", 1},   Option{"-blendv", 1},    Option{"-boost", 1},
                              Option{"-texres", 1},   Option{"-imfchan", 1},   Option{"-type", 1},
                              Option{"-cc", 1},       Option{"-colorspace", 1}};

const Option* optionNamed(View word) {
    const std::string name = inSmallLetters(word);
    const auto* const option = std::ranges::find(kOptions, View(name), &Option::name);
    return option == kOptions.end() ? nullptr : option;
}

View wordOf(View& text) {
    constexpr View kBlanks = " \t";
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
    const View word = text.substr(0, text.find_first_of(kBlanks));
    text.remove_prefix(word.size());
    return word;
}

void set(Vec2& to, int index, float value) {
    if (index == 0) to.x = value;
    if (index == 1) to.y = value;
}

void readOption(const Option& option, View& words, MapStatement& to) {
    for (int i = 0; i < option.words; ++i) {
        View rest = words;
        const View word = wordOf(rest);
        const auto number = numberOf(word);
        if (option.numbers && !number) return;
        words = rest;
        if (option.name == "-s" && number) set(to.layout.scale, i, *number);
        if (option.name == "-o" && number) set(to.layout.offset, i, *number);
        if (option.name == "-bm") to.bump = number.value_or(1.0F);
        if (option.name == "-clamp") to.clamped = inSmallLetters(word) == "on";
    }
}

/// The options at the beginning of `words`, which then begins behind them.
void readOptions(View& words, MapStatement& to) {
    for (View rest = words;; words = rest) {
        const Option* const option = optionNamed(wordOf(rest));
        if (option == nullptr) return;
        readOption(*option, rest, to);
    }
}

/// The length of the name in `words`: up to the first option that only options follow.
std::size_t lengthOfName(View words) {
    View rest = words;
    wordOf(rest);
    while (!rest.empty()) {
        const std::size_t at = words.size() - rest.size();
        View behind = rest;
        MapStatement ignored;
        if (optionNamed(wordOf(rest)) == nullptr) continue;
        readOptions(behind, ignored);
        if (wordOf(behind).empty()) return at;
    }
    return words.size();
}

} // namespace

MapStatement mapStatementOf(std::string_view words) {
    MapStatement statement;
    readOptions(words, statement);
    const std::size_t length = lengthOfName(words);
    View behind = words.substr(length);
    readOptions(behind, statement);
    statement.name = unquoted(words.substr(0, length));
    return statement;
}

} // namespace rtcore
