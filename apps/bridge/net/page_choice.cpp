#include "bridge/net/page_choice.h"

#include <algorithm>
#include <cctype>
#include <optional>

namespace bridge {

namespace {

std::string_view trimmed(std::string_view text) {
    const std::size_t from = text.find_first_not_of(" \t"), until = text.find_last_not_of(" \t");
    return from == std::string_view::npos ? std::string_view() : text.substr(from, until - from + 1);
}

/// The part before `separator`, which is taken away together with it.
std::string_view takePart(std::string_view& rest, char separator) {
    const std::size_t end = rest.find(separator);
    const std::string_view part = trimmed(rest.substr(0, end));
    rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    return part;
}

bool sameWord(std::string_view a, std::string_view b) {
    return std::ranges::equal(
        a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

/// "0", "0.", "0.00".
bool isZero(std::string_view weight) {
    return !weight.empty() && weight.front() == '0' &&
           weight.find_first_not_of("0.") == std::string_view::npos;
}

/// Whether a coding with these parameters is wanted: its weight, if any, is not 0.
bool hasWeight(std::string_view parameters) {
    while (!parameters.empty()) {
        std::string_view value = takePart(parameters, ';');
        if (sameWord(takePart(value, '='), "q")) return !isZero(trimmed(value));
    }
    return true;
}

} // namespace

bool takesGzip(std::string_view acceptEncoding) {
    std::optional<bool> any;
    while (!acceptEncoding.empty()) {
        std::string_view one = takePart(acceptEncoding, ',');
        const std::string_view coding = takePart(one, ';');
        if (sameWord(coding, "gzip") || sameWord(coding, "x-gzip")) return hasWeight(one);
        if (coding == "*") any = hasWeight(one);
    }
    return any.value_or(false);
}

bool namesTag(std::string_view ifNoneMatch, std::string_view tag) {
    if (trimmed(ifNoneMatch) == "*") return true;
    while (!ifNoneMatch.empty()) {
        std::string_view one = takePart(ifNoneMatch, ',');
        if (one.starts_with("W/")) one.remove_prefix(2);
        if (!one.empty() && one == tag) return true;
    }
    return false;
}

} // namespace bridge
