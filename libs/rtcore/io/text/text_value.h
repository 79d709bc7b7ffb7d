/// The content of a text file before it is interpreted: a tree of values with their positions.
#pragma once

#include "rtcore/platform/sentence.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rtcore {

/// Both from 1; the column counts characters, not bytes.
struct TextPosition {
    int line = 1, column = 1;
};

struct TextValue;
struct TextEntry;

using TextArray = std::vector<TextValue>;
/// The entries in the order of the file; no key twice.
struct TextTable {
    std::vector<TextEntry> entries;
};
/// A date or time: no format has a use for one.
struct TextDate {};

struct TextValue {
    TextPosition position;
    std::variant<TextDate, bool, std::int64_t, double, std::string, TextArray, TextTable> content;
};

struct TextEntry {
    std::string key;
    TextPosition position;
    TextValue value;
};

/// "a table", "text", ...
Sentence describeType(const TextValue& value);

} // namespace rtcore
