#include "common/progress/progress_format.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

using Json = nlohmann::ordered_json;

int percent(double fraction) { return static_cast<int>(std::floor(std::clamp(fraction, 0.0, 1.0) * 100)); }

} // namespace

std::string durationText(double seconds) {
    const auto whole = static_cast<long long>(std::ceil(std::clamp(seconds, 0.0, 1e9)));
    const long long hours = whole / 3600, minutes = whole / 60 % 60;
    if (hours > 0) return fmt::format("{}:{:02}:{:02}", hours, minutes, whole % 60);
    return fmt::format("{}:{:02}", minutes, whole % 60);
}

std::string barText(const ProgressState& state, int columns) {
    std::string head = state.phase, tail;
    if (state.frames > 1) head += fmt::format(" {}/{}", state.frame, state.frames);
    if (state.fraction) tail = fmt::format(" {:3}%", percent(*state.fraction));
    if (state.secondsLeft) tail += fmt::format(" {} left", durationText(*state.secondsLeft));

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
    if (state.frames > 1) text += fmt::format(" frame {} of {}", state.frame, state.frames);
    if (state.fraction) text += fmt::format(": {}%", percent(*state.fraction));
    if (state.secondsLeft) text += fmt::format(", {} left", durationText(*state.secondsLeft));
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
