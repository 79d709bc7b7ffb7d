#include "rtserver/commands/key_edits.h"

#include "common/commands/told_forms.h"

#include "rtcore/platform/sentence.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

namespace rtserver {

namespace {

rtcore::Sentence toggleBloom(Workspace& state, Host& host) {
    const auto isOn = [&] { return state.document.settings().bloom.radius != 0; };
    runCommand(app::CommandId::Bloom, std::array<std::string, 1>{isOn() ? "off" : "on"}, state, host);
    return rtcore::say(isOn() ? app::told::kBloomOn : app::told::kBloomOff);
}

rtcore::Sentence toggleLight(int id, Workspace& state, Host& host) {
    using rtcore::say;
    const std::optional<std::size_t> light = rtcore::lightWithId(*state.document.scene(), id);
    if (!light) return say(app::told::kNoLight, id);
    runCommand(app::CommandId::Light, std::array<std::string, 2>{std::to_string(id), "toggle"}, state, host);
    const bool on = state.document.scene()->lights[*light].light.on != 0;
    return say(on ? app::told::kLightOn : app::told::kLightOff, id);
}

rtcore::Sentence selectEnvironment(int environment, Workspace& state, Host& host) {
    using rtcore::say;
    const std::size_t count = state.document.scene()->environments.size();
    if (environment < 1 || std::cmp_greater(environment, count))
        return say(app::told::kNoEnvironment, environment);
    runCommand(app::CommandId::Environment, std::array{std::to_string(environment)}, state, host);
    return say(app::told::kEnvironment, environment);
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
