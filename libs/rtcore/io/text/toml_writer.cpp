#include "rtcore/io/text/toml_writer.h"

#include "rtcore/settings/number_text.h"
#include "rtcore/settings/plain_text.h"
#include "rtcore/settings/utf8.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>

namespace rtcore {

namespace {

/// Digits alone would be a TOML integer, which has no -0 and ends at 2^63.
std::string asTomlFloat(const std::string& digits) {
    const bool whole = digits.find_first_not_of("-0123456789") == std::string::npos;
    return whole ? digits + ".0" : digits;
}

float readByDouble(const std::string& digits) {
    double value = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return static_cast<float>(value);
}

template <typename Number>
std::string threeNumbers(Number a, Number b, Number c) {
    return fmt::format("[{}, {}, {}]", tomlNumber(a), tomlNumber(b), tomlNumber(c));
}

/// One character; what terminals obey, too, is written by its number.
std::string escaped(std::string_view character) {
    switch (character[0]) {
    case '"':
        return "\\\"";
    case '\\':
        return "\\\\";
    case '\n':
        return "\\n";
    case '\t':
        return "\\t";
    case '\r':
        return "\\r";
    default:
        break;
    }
    const std::optional<unsigned> control = controlCode(character);
    return control ? fmt::format("\\u{:04X}", *control) : std::string(character);
}

} // namespace

std::string tomlNumber(double value) { return asTomlFloat(shortestText(value)); }

std::string tomlNumber(float value) {
    const std::string digits = shortestText(value);
    // Rounding to double and then to float may differ from rounding once; then all digits are needed.
    return asTomlFloat(readByDouble(digits) == value ? digits : shortestText(static_cast<double>(value)));
}

std::string tomlString(std::string_view text) {
    std::string result = "\"";
    while (!text.empty()) {
        const std::size_t length = utf8Length(text);
        const std::string_view character = text.substr(0, std::max<std::size_t>(length, 1));
        result += length > 0 ? escaped(character) : std::string(character);
        text.remove_prefix(character.size());
    }
    return result + "\"";
}

void TomlWriter::section(std::string_view header) {
    if (!text_.empty()) text_ += "\n";
    text_.append(header).append("\n");
}

void TomlWriter::line(std::string_view key, std::string_view value) {
    text_.append(key).append(" = ").append(value).append("\n");
}

void TomlWriter::add(std::string_view key, bool value) { line(key, value ? "true" : "false"); }
void TomlWriter::add(std::string_view key, int value) { line(key, fmt::format("{}", value)); }
void TomlWriter::add(std::string_view key, float value) { line(key, tomlNumber(value)); }
void TomlWriter::add(std::string_view key, double value) { line(key, tomlNumber(value)); }
void TomlWriter::add(std::string_view key, std::string_view value) { line(key, tomlString(value)); }
void TomlWriter::add(std::string_view key, Vec3 value) { line(key, threeNumbers(value.x, value.y, value.z)); }
void TomlWriter::add(std::string_view key, Colour value) {
    line(key, threeNumbers(value.r, value.g, value.b));
}

void TomlWriter::add(std::string_view key, const FilePoint& value) {
    line(key, threeNumbers(value[0], value[1], value[2]));
}

void TomlWriter::add(std::string_view key, const std::vector<FilePoint>& values) {
    std::string list;
    for (const FilePoint& value : values)
        list += (list.empty() ? "" : ", ") + threeNumbers(value[0], value[1], value[2]);
    line(key, "[" + list + "]");
}

void TomlWriter::addPosition(std::string_view key, Vec3 value, const LocalOrigin& zero) {
    if (zero.isZero()) {
        add(key, value);
    } else {
        add(key, zero.inFile(value));
    }
}
void TomlWriter::add(std::string_view key, const LocalOrigin& value) {
    if (!value.isZero()) add(key, value.at);
}

void TomlWriter::add(std::string_view key, const std::vector<bool>& values) {
    std::string list;
    for (const bool value : values)
        list += (list.empty() ? "" : ", ") + std::string(value ? "true" : "false");
    line(key, "[" + list + "]");
}

void TomlWriter::add(std::string_view key, const std::vector<int>& values) {
    std::string list;
    for (const int value : values) list += (list.empty() ? "" : ", ") + std::to_string(value);
    line(key, "[" + list + "]");
}

void TomlWriter::add(std::string_view key, const std::vector<std::string>& values) {
    std::string list;
    for (const std::string& value : values) list += (list.empty() ? "" : ", ") + tomlString(value);
    line(key, "[" + list + "]");
}

void TomlWriter::add(std::string_view key, const SettingValue& value) {
    std::visit([&](const auto& content) { add(key, content); }, value);
}

} // namespace rtcore
