#include "rtcore/scene/model_origin.h"

#include "rtcore/scene/up_axis.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>

namespace rtcore {

namespace {

constexpr std::size_t kMaxWords = 1500;

std::string oneLine(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c >= 0x7F; }, '?');
    return text.substr(0, kMaxWords);
}

std::optional<double> positive(std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    return whole && value > 0 && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::string numberText(double value) {
    std::array<char, 32> text{};
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), end};
}

std::string pointText(const FilePoint& p) {
    return numberText(p[0]) + ' ' + numberText(p[1]) + ' ' + numberText(p[2]);
}

/// Three numbers that positions may have, with a blank between them.
std::optional<LocalOrigin> zeroOf(std::string_view text) {
    constexpr double kFarthest = 1e12;
    LocalOrigin origin;
    for (double& value : origin.at) {
        if (text.starts_with(' ')) text.remove_prefix(1);
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || !(std::fabs(value) <= kFarthest)) return {};
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    }
    return text.empty() ? std::optional(origin) : std::nullopt;
}

} // namespace

std::string writeOrigin(const ModelOrigin& origin) {
    std::string text;
    const auto add = [&](const char* name, const std::string& value) {
        if (!value.empty()) text += std::string(name) + ' ' + value + '\n';
    };
    add("format", oneLine(origin.format));
    add("exporter", oneLine(origin.exporter));
    if (origin.up) add("up", std::string(axisName(*origin.up)));
    if (origin.metresPerUnit) add("metresPerUnit", numberText(*origin.metresPerUnit));
    if (!origin.zero.isZero()) add("zero", pointText(origin.zero.at));
    return text;
}

bool readOriginLine(std::string_view line, ModelOrigin& origin) {
    const std::size_t space = line.find(' ');
    if (space == std::string_view::npos) return false;
    const std::string_view name = line.substr(0, space), value = line.substr(space + 1);
    if (name == "format") {
        origin.format = oneLine(std::string(value));
    } else if (name == "exporter") {
        origin.exporter = oneLine(std::string(value));
    } else if (name == "up") {
        origin.up = axisNamed(value);
    } else if (name == "metresPerUnit") {
        origin.metresPerUnit = positive(value);
    } else if (name == "zero") {
        origin.zero = zeroOf(value).value_or(LocalOrigin());
    } else {
        return false;
    }
    return true;
}

ModelOrigin readOrigin(std::string_view text) {
    ModelOrigin origin;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        readOriginLine(text.substr(0, end), origin);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return origin;
}

} // namespace rtcore
