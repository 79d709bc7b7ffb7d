#include "rtcore/io/import/text/statement_text.h"

#include "rtcore/io/import/text/plain_number.h"
#include "rtcore/math/nearest_float.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <limits>
#include <system_error>

namespace rtcore {

namespace {

constexpr std::string_view kAllBlanks(" \t\v\f\0", 5);

/// Of doubles: floats that are too small are 0, and too large ones infinite.
std::optional<float> outsideOfFloats(const char* first, const char* last) {
    double value = 0;
    const auto [end, error] = std::from_chars(first, last, value);
    if (end != last || error == std::errc::invalid_argument) return std::nullopt;
    if (error == std::errc()) return static_cast<float>(value);
    const std::string_view word(first, static_cast<std::size_t>(last - first));
    const std::size_t exponent = word.find_first_of("eE");
    const bool small = exponent != std::string_view::npos
                           ? word.substr(exponent).find('-') != std::string_view::npos
                           : word.find("0.") < 2;
    const float sign = word.starts_with('-') ? -1.0F : 1.0F;
    return small ? 0.0F : sign * std::numeric_limits<float>::infinity();
}

} // namespace

std::string StatementText::rest() {
    std::string text;
    while (hasWord()) {
        const char* const first = at_;
        while (!isLineEnd(*at_) && !(*at_ == '\\' && isLineEnd(at_[1]))) ++at_;
        std::string_view part(first, static_cast<std::size_t>(at_ - first));
        part = part.substr(0, part.find_last_not_of(kAllBlanks) + 1);
        if (!text.empty()) text += ' ';
        text += part;
    }
    return text;
}

std::optional<float> StatementText::number() {
    if (!hasWord()) return std::nullopt;
    const char* const first = *at_ == '+' ? at_ + 1 : at_;
    float value = 0;
    const char* const before = at_;
    if (const char* const plain = readPlainFloat(first, value)) {
        at_ = plain;
        if (endsWord()) return value;
        at_ = before;
        return numberOf(word());
    }
    const auto [end, error] = std::from_chars(first, end_, value);
    at_ = error == std::errc::invalid_argument ? at_ : end;
    if (error == std::errc() && endsWord()) return value;
    at_ = before;
    return numberOf(word());
}

std::optional<float> StatementText::coordinate(double zero) {
    if (zero == 0) return number();
    if (!hasWord()) return std::nullopt;
    const auto number = preciseNumberOf(word());
    return number ? std::optional(nearestFloat(*number - zero)) : std::nullopt;
}

std::optional<double> StatementText::preciseNumber() {
    std::string_view text = word();
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0;
    const char* const last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), last, value);
    return end == last && error == std::errc() ? std::optional(value) : std::nullopt;
}

namespace {

/// With a comma before its fraction in place of the point; "" for what has none alone.
std::string withPoint(std::string_view word) {
    const std::size_t comma = word.find(',');
    if (comma == std::string_view::npos || word.find_first_of(",.", comma + 1) != std::string_view::npos)
        return {};
    std::string pointed(word);
    pointed[comma] = '.';
    return pointed.find('.') == comma ? pointed : std::string();
}

template <typename Number>
std::optional<Number> parsed(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    const char* const last = word.data() + word.size();
    Number value = 0;
    const auto [end, error] = std::from_chars(word.data(), last, value);
    if (end == last && error == std::errc()) return value;
    if (error == std::errc::result_out_of_range) return outsideOfFloats(word.data(), last);
    const std::string pointed = withPoint(word);
    return pointed.empty() ? std::nullopt : parsed<Number>(pointed);
}

} // namespace

std::optional<float> numberOf(std::string_view word) { return parsed<float>(word); }
std::optional<double> preciseNumberOf(std::string_view word) { return parsed<double>(word); }

std::string inSmallLetters(std::string_view text) {
    std::string result(text);
    std::ranges::transform(result, result.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

std::string_view unquoted(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(kAllBlanks), text.size()));
    text = text.substr(0, text.find_last_not_of(kAllBlanks) + 1);
    const bool quoted = text.size() >= 2 && text.front() == '"' && text.back() == '"';
    return quoted ? text.substr(1, text.size() - 2) : text;
}

std::size_t wholeStatements(std::string_view piece) {
    for (std::size_t end = piece.size(); end > 0; --end) {
        const char c = piece[end - 1];
        if (c != '\n' && c != '\r') continue;
        if (c == '\r' && end == piece.size()) continue; // a line feed may follow
        std::size_t before = end - 1;
        if (c == '\n' && before > 0 && piece[before - 1] == '\r') --before;
        if (before > 0 && piece[before - 1] == '\\') continue;
        return end;
    }
    return 0;
}

} // namespace rtcore
