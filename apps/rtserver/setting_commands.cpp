// Commands for what is rendered and how well: settings, lights, environments.
#include "rtserver/command_call.h"

#include "rtcore/settings/settings_table.h"

#include <array>
#include <optional>
#include <utility>

namespace rtserver {

namespace {

void assign(const Call& call, std::span<const std::pair<std::string, std::string>> assignments) {
    rtcore::RenderSettings settings = call.session.settings();
    for (const auto& [name, value] : assignments) rtcore::setSettingFromText(settings, name, value);
    call.session.setSettings(settings);
}

Result set(const Call& call) {
    assign(call, std::array{std::pair{call[0], call[1]}});
    return {};
}

Result resolution(const Call& call) {
    assign(call,
           std::array{std::pair{std::string("width"), call[0]}, std::pair{std::string("height"), call[1]}});
    return {};
}

Result get(const Call& call) {
    return {.answer = rtcore::settingText(rtcore::getSetting(call.session.settings(), call[0]))};
}

Result settings(const Call& call) {
    std::string text;
    for (const auto& [name, value] : rtcore::settingAssignments(call.session.settings(), true))
        text += (text.empty() ? "" : "\n") + name + " = " + rtcore::settingText(value);
    return {.answer = text};
}

Result bloom(const Call& call) {
    call.session.switchBloom(flag(call[0]));
    return {};
}

Result light(const Call& call) {
    const bool toggle = call[1] == "toggle";
    call.session.switchLight(integer(call[0]), toggle ? std::nullopt : std::optional(flag(call[1])));
    return {};
}

Result environment(const Call& call) {
    call.session.setEnvironment(integer(call[0]));
    return {};
}

constexpr std::array kCommands{
    Command{"set", 2, 2, "NAME VALUE", true, set},
    Command{"get", 1, 1, "NAME", true, get},
    Command{"settings", 0, 0, "", true, settings},
    Command{"resolution", 2, 2, "WIDTH HEIGHT", true, resolution},
    Command{"bloom", 1, 1, "on|off", true, bloom},
    Command{"light", 2, 2, "N on|off|toggle", true, light},
    Command{"environment", 1, 1, "N", true, environment},
};

} // namespace

std::span<const Command> settingCommands() { return kCommands; }

} // namespace rtserver
