#include "common/progress/progress_format.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace app {

namespace {

using Json = nlohmann::ordered_json;

int percent(double fraction) { return static_cast<int>(std::floor(std::clamp(fraction, 0.0, 1.0) * 100)); }

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
    const auto rounded = [](const std::optional<double>& value, double steps) {
        return value ? Json(std::round(*value * steps) / steps) : Json();
    };
    const auto count = [](int value) { return value > 0 ? Json(value) : Json(); };
    const Json json{{"phase", state.phase},
                    {"fraction", rounded(state.fraction, 1e4)},
                    {"frame", count(state.frame)},
                    {"frames", count(state.frames)},
                    {"secondsLeft", rounded(state.secondsLeft, 10)}};
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

} // namespace app
