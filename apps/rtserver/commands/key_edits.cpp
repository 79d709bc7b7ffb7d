#include "rtserver/commands/key_edits.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

namespace rtserver {

namespace {

std::string toggleBloom(Workspace& state, Host& host) {
    const auto isOn = [&] { return state.document.settings().bloom.radius != 0; };
    runCommand(app::CommandId::Bloom, std::array<std::string, 1>{isOn() ? "off" : "on"}, state, host);
    return isOn() ? "bloom on" : "bloom off";
}

std::string toggleLight(int id, Workspace& state, Host& host) {
    const std::string number = std::to_string(id), name = "light " + number;
    const std::optional<std::size_t> light = rtcore::lightWithId(*state.document.scene(), id);
    if (!light) return "there is no " + name;
    runCommand(app::CommandId::Light, std::array<std::string, 2>{number, "toggle"}, state, host);
    return name + (state.document.scene()->lights[*light].light.on != 0 ? " on" : " off");
}

std::string selectEnvironment(int environment, Workspace& state, Host& host) {
    const std::string number = std::to_string(environment), name = "environment " + number;
    const std::size_t count = state.document.scene()->environments.size();
    if (environment < 1 || std::cmp_greater(environment, count)) return "there is no " + name;
    runCommand(app::CommandId::Environment, std::array{number}, state, host);
    return name;
}

} // namespace

void editByKey(const rtcore::ActionTap& tap, Workspace& state, Host& host, Messages& messages) {
    if (tap.action == rtcore::Action::ToggleBloom)
        messages.tell(toggleBloom(state, host));
    else if (tap.action == rtcore::Action::ToggleLight)
        messages.tell(toggleLight(tap.number, state, host));
    else if (tap.action == rtcore::Action::SelectEnvironment)
        messages.tell(selectEnvironment(tap.number, state, host));
}

} // namespace rtserver
