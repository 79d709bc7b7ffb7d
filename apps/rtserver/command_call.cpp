#include "rtserver/command_call.h"

#include "common/cli/command_line.h"

#include "rtcore/motion/key_codes.h"
#include "rtcore/settings/nearest_name.h"

#include <cmath>
#include <optional>

namespace rtserver {

float number(const std::string& text) {
    constexpr double kMost = 1e30;
    const std::optional<double> value = app::parseNumber(text);
    if (!value || std::fabs(*value) > kMost) throw app::UsageError(rtcore::quoted(text) + " is no number");
    return static_cast<float>(*value);
}

int integer(const std::string& text) {
    const std::optional<std::int64_t> value = app::parseInteger(text);
    constexpr std::int64_t kMost = 1'000'000'000;
    if (!value || *value < -kMost || *value > kMost)
        throw app::UsageError(rtcore::quoted(text) + " is no whole number");
    return static_cast<int>(*value);
}

bool flag(const std::string& text) {
    if (text == "on") return true;
    if (text != "off") throw app::UsageError(rtcore::quoted(text) + " is neither on nor off");
    return false;
}

int keyOf(const std::string& name) {
    const std::optional<int> code = rtcore::keyNamed(name);
    if (!code) {
        throw app::UsageError(
            "unknown key " + rtcore::quoted(name) +
            "; there are letters, digits, Space, Left, Right, Up, Down, Shift, Control, CapsLock "
            "and others");
    }
    return *code;
}

std::filesystem::path pathOf(const std::string& text) {
    std::filesystem::path path(text);
    if (!path.is_absolute()) throw app::UsageError("the path " + rtcore::quoted(text) + " is not absolute");
    return path;
}

} // namespace rtserver
