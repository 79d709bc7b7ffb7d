#include "rtcore/io/import/threemf/attribute_values.h"

#include "rtcore/io/import/materials/material_mapping.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

namespace rtcore::threemf {

namespace {

constexpr std::string_view kBlanks = " \t\r\n";

std::string_view trimmed(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
    while (!text.empty() && kBlanks.find(text.back()) != std::string_view::npos) text.remove_suffix(1);
    if (text.starts_with('+')) text.remove_prefix(1);
    return text;
}

template <typename Number>
std::optional<Number> parsed(Value text) {
    if (!text) return std::nullopt;
    const std::string_view word = trimmed(*text);
    Number number{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
    return number;
}

} // namespace

std::uint32_t numberOf(Value text) { return parsed<std::uint32_t>(text).value_or(kNoNumber); }

float realOf(Value text, float otherwise) {
    const auto number = parsed<float>(text);
    return number && std::isfinite(*number) ? *number : otherwise;
}

float coordinateOf(Value text) {
    return parsed<float>(text).value_or(std::numeric_limits<float>::quiet_NaN());
}

Paint paintOf(Value text) {
    const std::string_view word = trimmed(text.value_or(""));
    std::uint32_t code = 0;
    const bool hasAlpha = word.size() == 9;
    const bool fits = word.starts_with('#') && (hasAlpha || word.size() == 7);
    const auto [end, error] =
        std::from_chars(word.data() + (fits ? 1 : 0), word.data() + word.size(), code, 16);
    if (!fits || error != std::errc() || end != word.data() + word.size()) return {kUnsetDiffuse, 1};
    if (!hasAlpha) code = code << 8U | 0xFFU;
    const auto part = [code](unsigned shift) { return static_cast<float>(code >> shift & 0xFFU) / 255; };
    return {{srgbDecode(part(24)), srgbDecode(part(16)), srgbDecode(part(8))}, part(0)};
}

Affine transformOf(Value text) {
    Affine transform;
    std::size_t count = 0;
    bool sound = text.has_value();
    forEachWord(text.value_or(""), [&](std::string_view word) {
        const auto number = parsed<double>(word);
        sound = sound && number && std::isfinite(*number) && count < 12;
        if (sound) transform.m[count % 3][count / 3] = *number;
        ++count;
    });
    return sound && count == 12 ? transform : Affine{};
}

TextureWrap wrapOf(Value text) {
    if (text == "mirror") return TextureWrap::MirroredRepeat;
    return text == "clamp" || text == "none" ? TextureWrap::ClampToEdge : TextureWrap::Repeat;
}

double metresOf(std::string_view unit) {
    constexpr std::array<std::pair<std::string_view, double>, 6> kUnits{{{"micron", 1e-6},
                                                                         {"millimeter", 0.001},
                                                                         {"centimeter", 0.01},
                                                                         {"inch", 0.0254},
                                                                         {"foot", 0.3048},
                                                                         {"meter", 1}}};
    for (const auto& [name, metres] : kUnits)
        if (unit == name) return metres;
    return 0.001;
}

void forEachWord(std::string_view text, const std::function<void(std::string_view)>& use) {
    while (true) {
        text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
        if (text.empty()) return;
        const std::size_t end = std::min(text.find_first_of(kBlanks), text.size());
        use(text.substr(0, end));
        text.remove_prefix(end);
    }
}

std::vector<std::uint32_t> numbersOf(Value text) {
    std::vector<std::uint32_t> numbers;
    forEachWord(text.value_or(""), [&](std::string_view word) { numbers.push_back(numberOf(word)); });
    return numbers;
}

} // namespace rtcore::threemf
