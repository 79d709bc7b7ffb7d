// Commands for what is rendered and how well: settings, lights, environments.
#include "rtserver/command_call.h"

#include "rtcore/settings/settings_table.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
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

// Counted from 1, as on the keys.
int indexOf(const std::string& number) {
    const int counted = integer(number);
    return counted > 0 ? counted - 1 : -1;
}

Result light(const Call& call) {
    const bool toggle = call[1] == "toggle";
    call.session.switchLight(indexOf(call[0]), toggle ? std::nullopt : std::optional(flag(call[1])));
    return {};
}

Result environment(const Call& call) {
    call.session.setEnvironment(indexOf(call[0]));
    return {};
}

std::string numbered(std::size_t index, const std::string& state, const std::string& name) {
    return std::to_string(index + 1) + ' ' + state + (name.empty() ? "" : ' ' + name) + '\n';
}

Result withoutLastEnd(std::string text) {
    if (!text.empty()) text.pop_back();
    return {.answer = std::move(text)};
}

Result lights(const Call& call) {
    const rtcore::Scene& scene = call.session.world().loaded.scene;
    std::string text;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const std::string name = i < scene.lightNames.size() ? scene.lightNames[i] : std::string();
        text += numbered(i, scene.lights[i].on != 0 ? "on" : "off", name);
    }
    return withoutLastEnd(std::move(text));
}

// One without a name goes by its file.
std::string nameOf(const rtcore::EnvironmentFile& environment) {
    const bool named = !environment.name.empty() || environment.files.empty();
    return named ? environment.name : environment.files.front().stem().string();
}

Result environments(const Call& call) {
    const rtcore::LoadedScene& loaded = call.session.world().loaded;
    std::string text;
    for (std::size_t i = 0; i < loaded.scene.environments.size(); ++i) {
        const bool described = loaded.sceneFile && i < loaded.sceneFile->environments.size();
        const std::string name = described ? nameOf(loaded.sceneFile->environments[i]) : std::string();
        const bool active = std::cmp_equal(loaded.scene.activeEnvironment, i);
        text += numbered(i, active ? "active" : "-", name);
    }
    return withoutLastEnd(std::move(text));
}

Result scene(const Call& call) {
    return {.answer = std::filesystem::absolute(call.session.world().source).lexically_normal().string()};
}

constexpr std::array kCommands{
    Command{"set", 2, 2, "NAME VALUE", true, set},
    Command{"get", 1, 1, "NAME", true, get, Effect::Tells},
    Command{"settings", 0, 0, "", true, settings, Effect::Tells},
    Command{"resolution", 2, 2, "WIDTH HEIGHT", true, resolution},
    Command{"bloom", 1, 1, "on|off", true, bloom},
    Command{"light", 2, 2, "N on|off|toggle", true, light},
    Command{"environment", 1, 1, "N", true, environment},
    Command{"lights", 0, 0, "", true, lights, Effect::Tells},
    Command{"environments", 0, 0, "", true, environments, Effect::Tells},
    Command{"scene", 0, 0, "", true, scene, Effect::Tells},
};

} // namespace

std::span<const Command> settingCommands() { return kCommands; }

} // namespace rtserver
