#include "rtcore/io/text/toml_parser.h"

#include "rtcore/io/text/text_file.h"
#include "rtcore/io/text/toml_guard.h"
#include "rtcore/io/text/toml_texts.h"
#include "rtcore/platform/error.h"
#include "rtcore/settings/utf8.h"

#include <toml++/toml.h>

#include <algorithm>
#include <tuple>

namespace rtcore {

namespace {

TextPosition positionOf(const toml::source_region& region) {
    return {static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

// Both recurse at most as deep as guardToml lets brackets and keys nest.
TextValue convert(const toml::node& node);

TextTable convertTable(const toml::table& table) {
    TextTable result;
    result.entries.reserve(table.size());
    for (const auto& [key, node] : table)
        result.entries.push_back({std::string(key.str()), positionOf(key.source()), convert(node)});
    // toml++ sorts by key.
    std::sort(result.entries.begin(), result.entries.end(), [](const TextEntry& a, const TextEntry& b) {
        return std::tie(a.position.line, a.position.column) < std::tie(b.position.line, b.position.column);
    });
    return result;
}

TextArray convertArray(const toml::array& array) {
    TextArray result;
    result.reserve(array.size());
    for (const toml::node& node : array) result.push_back(convert(node));
    return result;
}

TextValue convert(const toml::node& node) {
    TextValue value;
    value.position = positionOf(node.source());
    if (const auto* table = node.as_table()) value.content = convertTable(*table);
    if (const auto* array = node.as_array()) value.content = convertArray(*array);
    if (const auto* text = node.as_string()) value.content = text->get();
    if (const auto* whole = node.as_integer()) value.content = whole->get();
    if (const auto* number = node.as_floating_point()) value.content = number->get();
    if (const auto* flag = node.as_boolean()) value.content = flag->get();
    return value;
}

/// toml++ checks this, too, but points one character too far to the left.
void checkUtf8(std::string_view text, const std::string& file) {
    const std::size_t invalid = findInvalidUtf8(text);
    if (invalid == std::string_view::npos) return;
    const TextPosition position = positionAt(text, invalid);
    throw FileError(FailureKind::BadData, file, "this byte is no text; save the file as UTF-8", position.line,
                    position.column);
}

} // namespace

TextValue parseToml(std::string_view text, const std::string& file) {
    checkUtf8(text, file);
    guardToml(text, file);
    try {
        TextValue root = convert(toml::parse(text));
        root.position = {1, 1};
        return root;
    } catch (const toml::parse_error& error) {
        const TextPosition position = positionOf(error.source());
        throw FileError(FailureKind::BadData, file, meaningOf(error.description(), kTomlTexts), position.line,
                        position.column);
    }
}

} // namespace rtcore
