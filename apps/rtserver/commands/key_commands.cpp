// Commands that press keys, and say what keys do.
#include "rtserver/commands/command_call.h"

#include "common/cli/command_line.h"

#include "rtcore/motion/key_bindings.h"
#include "rtcore/motion/key_codes.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/settings/nearest_name.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <stdexcept>
#include <vector>

namespace rtserver {

namespace {

Result press(const Call& call) {
    const int key = keyOf(call[0]);
    if (call.size() == 1) {
        call.walk().keyboard().press(key);
        return {};
    }
    if (call.state.paused) throw rtcore::Refusal("the server is paused; resume it first");
    const std::uint64_t press =
        call.walk().keyboard().pressFor(key, std::chrono::milliseconds(integer(call[1])));
    return {.when = ReplyWhen::WhenReleased, .press = press};
}

Result release(const Call& call) {
    if (call[0] == "all") {
        call.walk().keyboard().releaseAll();
    } else {
        call.walk().keyboard().release(keyOf(call[0]));
    }
    return {};
}

Result tap(const Call& call) {
    call.walk().keyboard().tap(keyOf(call[0]));
    return {};
}

// --- Bindings ---

struct Keys {
    int key = rtcore::KeyNone, with = rtcore::KeyNone;
};

// "W", or "M+3": 3 while M is down.
Keys keysOf(const std::string& text) {
    const std::size_t plus = text.find('+', 1);
    if (plus == std::string::npos || plus + 1 == text.size()) return {keyOf(text), rtcore::KeyNone};
    return {keyOf(text.substr(plus + 1)), keyOf(text.substr(0, plus))};
}

rtcore::Action actionOf(const std::string& name) {
    if (const std::optional<rtcore::Action> action = rtcore::actionNamed(name)) return *action;
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < rtcore::kActions; ++i)
        names.push_back(rtcore::actionName(static_cast<rtcore::Action>(i)));
    throw app::UsageError(rtcore::unknownNameMessage(rtcore::form("action"), name, names));
}

std::string textOf(const rtcore::KeyBinding& binding) {
    std::string text;
    if (binding.with != rtcore::KeyNone) text = rtcore::keyName(binding.with) + "+";
    text.append(rtcore::keyName(binding.key)).append(" ").append(rtcore::actionName(binding.action));
    if (rtcore::hasNumber(binding.action)) text += fmt::format(" {}", binding.number);
    return text;
}

std::vector<rtcore::KeyBinding> without(const Walk& walk, const Keys& keys) {
    const std::span<const rtcore::KeyBinding> list = walk.bindings().list();
    std::vector<rtcore::KeyBinding> result(list.begin(), list.end());
    std::erase_if(result,
                  [&](const rtcore::KeyBinding& b) { return b.key == keys.key && b.with == keys.with; });
    return result;
}

Result bindings(const Call& call) {
    std::string text;
    for (const rtcore::KeyBinding& binding : call.walk().bindings().list())
        text += (text.empty() ? "" : "\n") + textOf(binding);
    return {.answer = text};
}

Result defaultBindings(const Call& call) {
    call.walk().setBindings(rtcore::KeyBindings());
    return {};
}

Result bind(const Call& call) {
    const Keys keys = keysOf(call[0]);
    rtcore::KeyBinding binding{keys.key, actionOf(call[1]), keys.with};
    if (rtcore::hasNumber(binding.action) != (call.size() == 3)) {
        throw app::UsageError(
            rtcore::say(call.size() == 3 ? "{0} takes no number" : "{0} takes a number, from 1", call[1]));
    }
    if (call.size() == 3) binding.number = integer(call[2]);
    std::vector<rtcore::KeyBinding> list = without(call.walk(), keys);
    list.push_back(binding);
    call.walk().setBindings(rtcore::KeyBindings(list));
    return {};
}

Result unbind(const Call& call) {
    const std::vector<rtcore::KeyBinding> list = without(call.walk(), keysOf(call[0]));
    if (list.size() == call.walk().bindings().list().size())
        throw app::UsageError(rtcore::say("{0} is not bound", rtcore::inQuotes(call[0])));
    call.walk().setBindings(rtcore::KeyBindings(list));
    return {};
}

constexpr std::array kKeyFunctions{
    CommandFunction{app::CommandId::KeyPress, press},
    CommandFunction{app::CommandId::KeyRelease, release},
    CommandFunction{app::CommandId::KeyTap, tap},
    CommandFunction{app::CommandId::Bindings, bindings},
    CommandFunction{app::CommandId::BindingsDefault, defaultBindings},
    CommandFunction{app::CommandId::Bind, bind},
    CommandFunction{app::CommandId::Unbind, unbind},
};

} // namespace

std::span<const CommandFunction> keyFunctions() { return kKeyFunctions; }

} // namespace rtserver
