#include "rtcore/io/text/toml_writer.h"

#include "rtcore/settings/number_text.h"

#include <fmt/core.h>

#include <charconv>
#include <cstdint>

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

std::string threeNumbers(float a, float b, float c) {
    return fmt::format("[{}, {}, {}]", tomlNumber(a), tomlNumber(b), tomlNumber(c));
}

std::string escaped(char c) {
    switch (c) {
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
    constexpr std::string_view digits = "0123456789ABCDEF";
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte != 0x7F) return {c};
    return {'\\', 'u', '0', '0', digits[byte >> 4U], digits[byte & 15U]};
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
    for (const char c : text) result += escaped(c);
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
