// Commands for what is rendered and how well: settings, environments; and what takes edits back.
#include "rtserver/commands/command_call.h"
#include "rtserver/commands/state_report_of.h"
#include "rtserver/document/sky_edits.h"

#include "ipc/layout/limits.h"

#include "rtcore/settings/plain_text.h"
#include "rtcore/settings/quality.h"
#include "rtcore/settings/settings_table.h"

#include <fmt/core.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rtserver {

namespace {

void assign(const Call& call, std::span<const std::pair<std::string, std::string>> assignments) {
    rtcore::RenderSettings settings = call.document().settings();
    for (const auto& [name, value] : assignments) rtcore::setSettingFromText(settings, name, value);
    call.document().setSettings(settings);
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

Result getSetting(const Call& call) {
    return {.answer = rtcore::settingText(rtcore::getSetting(call.document().settings(), call[0]))};
}

// The size follows windows and has no usual value.
Result defaults(const Call& call) {
    const rtcore::RenderSettings& now = call.document().settings();
    rtcore::RenderSettings settings;
    settings.width = now.width;
    settings.height = now.height;
    call.document().setSettings(settings);
    return {};
}

Result quality(const Call& call) {
    if (call.size() > 0) call.document().assign(rtcore::settingsOf(*rtcore::qualityNamed(call[0])));
    const auto now = rtcore::qualityOf(call.document().settings());
    return {.answer = now ? std::string(rtcore::kQualityNames.at(static_cast<std::size_t>(*now))) : "custom"};
}

std::optional<int> numberOf(const Call& call) {
    return call.size() > 0 ? std::optional(integer(call[0])) : std::nullopt;
}
Result undo(const Call& call) { return {.answer = rtcore::printable(call.document().undo(numberOf(call)))}; }
Result redo(const Call& call) { return {.answer = rtcore::printable(call.document().redo(numberOf(call)))}; }

Result settings(const Call& call) {
    std::string text;
    for (const auto& [name, value] : rtcore::settingAssignments(call.document().settings(), true))
        text += (text.empty() ? "" : "\n") + name + " = " + rtcore::settingText(value);
    return {.answer = text};
}

Result bloom(const Call& call) {
    call.document().switchBloom(flag(call[0]));
    return {};
}

// Counted from 1, as on the keys.
int indexOf(const std::string& number) { return integer(number) - 1; }

Result environment(const Call& call) {
    setEnvironment(call.document(), indexOf(call[0]));
    return {};
}

std::string numbered(std::size_t index, const std::string& state, const std::string& name) {
    return fmt::format("{} {}{}{}\n", index + 1, state, name.empty() ? "" : " ", rtcore::printable(name));
}

Result withoutLastEnd(std::string text) {
    if (!text.empty()) text.pop_back();
    return {.answer = std::move(text)};
}

std::string list(const std::vector<app::NamedSwitch>& switches, const char* on, const char* off) {
    std::string text;
    for (std::size_t i = 0; i < switches.size(); ++i)
        text += numbered(i, switches[i].on ? on : off, switches[i].name);
    return text;
}

Result environments(const Call& call) {
    return withoutLastEnd(list(environmentsOf(call.document()), "active", "-"));
}

Result scene(const Call& call) { return {.answer = scenePathOf(call.document())}; }

Result state(const Call& call) {
    return {.answer =
                app::formatStateReport(stateReportOf(call.document(), call.client), ipc::kMaxAnswerText)};
}

constexpr std::array kSettingFunctions{
    CommandFunction{app::CommandId::Set, set},
    CommandFunction{app::CommandId::Get, getSetting},
    CommandFunction{app::CommandId::Defaults, defaults},
    CommandFunction{app::CommandId::Quality, quality},
    CommandFunction{app::CommandId::Settings, settings},
    CommandFunction{app::CommandId::State, state},
    CommandFunction{app::CommandId::Undo, undo},
    CommandFunction{app::CommandId::Redo, redo},
    CommandFunction{app::CommandId::Resolution, resolution},
    CommandFunction{app::CommandId::Bloom, bloom},
    CommandFunction{app::CommandId::Environment, environment},
    CommandFunction{app::CommandId::Environments, environments},
    CommandFunction{app::CommandId::Scene, scene},
};

} // namespace

std::span<const CommandFunction> settingFunctions() { return kSettingFunctions; }

} // namespace rtserver
