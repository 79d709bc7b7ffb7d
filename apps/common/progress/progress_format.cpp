#include "common/progress/progress_format.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace app {

namespace {

int percent(double fraction) { return static_cast<int>(std::floor(std::clamp(fraction, 0.0, 1.0) * 100)); }

// With a decimal point in every locale.
std::string number(double value, int decimals) {
    char digits[64];
    const auto result =
        std::to_chars(std::begin(digits), std::end(digits), value, std::chars_format::fixed, decimals);
    return result.ec == std::errc() ? std::string(digits, result.ptr) : "null";
}

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    return result + '"';
}

std::string twoDigits(long long value) { return (value < 10 ? "0" : "") + std::to_string(value); }

} // namespace

std::string durationText(double seconds) {
    const auto whole = static_cast<long long>(std::ceil(std::clamp(seconds, 0.0, 1e9)));
    const long long hours = whole / 3600, minutes = whole / 60 % 60;
    if (hours > 0) return std::to_string(hours) + ":" + twoDigits(minutes) + ":" + twoDigits(whole % 60);
    return std::to_string(minutes) + ":" + twoDigits(whole % 60);
}

std::string barText(const ProgressState& state, int columns) {
    std::string head = state.phase, tail;
    if (state.frames > 1) head += " " + std::to_string(state.frame) + "/" + std::to_string(state.frames);
    if (state.fraction) {
        char digits[8];
        std::snprintf(digits, sizeof digits, " %3d%%", percent(*state.fraction));
        tail = digits;
    }
    if (state.secondsLeft) tail += " " + durationText(*state.secondsLeft) + " left";

    const auto room = static_cast<std::size_t>(std::max(1, columns - 1));
    const std::size_t used = head.size() + tail.size() + 3;
    if (state.fraction && used + 10 <= room) {
        const std::size_t cells = std::min<std::size_t>(40, room - used);
        const auto full =
            static_cast<std::size_t>(std::clamp(*state.fraction, 0.0, 1.0) * static_cast<double>(cells));
        head += " [" + std::string(full, '#') + std::string(cells - full, ' ') + "]";
    }
    return (head + tail).substr(0, room);
}

std::string plainText(const ProgressState& state) {
    std::string text = state.phase;
    if (state.frames > 1) {
        text += " frame " + std::to_string(state.frame) + " of " + std::to_string(state.frames);
    }
    if (state.fraction) text += ": " + std::to_string(percent(*state.fraction)) + "%";
    if (state.secondsLeft) text += ", " + durationText(*state.secondsLeft) + " left";
    return text;
}

std::string jsonText(const ProgressState& state) {
    const auto orNull = [](const std::optional<double>& value, int decimals) {
        return value ? number(*value, decimals) : "null";
    };
    const auto count = [](int value) { return value > 0 ? std::to_string(value) : "null"; };
    return "{\"phase\":" + quoted(state.phase) + ",\"fraction\":" + orNull(state.fraction, 4) +
           ",\"frame\":" + count(state.frame) + ",\"frames\":" + count(state.frames) +
           ",\"secondsLeft\":" + orNull(state.secondsLeft, 1) + "}";
}

} // namespace app
