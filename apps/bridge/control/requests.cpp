#include "bridge/control/requests.h"

#include "bridge/control/request_words.h"
#include "bridge/control/setting_value.h"

#include "common/cli/command_line.h"
#include "common/commands/command_lookup.h"
#include "common/commands/quoting.h"

#include "rtcore/platform/sentence.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string_view>
#include <vector>

namespace bridge {

namespace {

using app::BrowserUse;
using app::CommandId;
using app::CommandSpec;
using nlohmann::json;

constexpr std::size_t kMaxArguments = 64;

const CommandSpec& commandOf(const json& request) {
    const auto found = request.find("do");
    if (found == request.end() || !found->is_string()) throw Refused("'do' is a text");
    const CommandSpec* const command = app::commandNamed(found->get_ref<const std::string&>());
    if (command == nullptr || !isRequest(*command)) throw Refused("there is no such request");
    return *command;
}

const json& argumentsOf(const json& request) {
    static const json none = json::array();
    const auto found = request.find("args");
    const json& all = found == request.end() ? none : *found;
    if (!all.is_array() || all.size() > kMaxArguments)
        throw Refused(rtcore::say("'args' is a list of {0} at most", kMaxArguments));
    return all;
}

bool isAlso(const json& request) {
    const auto found = request.find("also");
    if (found == request.end() || found->is_null()) return false;
    if (!found->is_boolean()) throw Refused("'also' is true or false");
    return found->get<bool>();
}

/// The first sky of a scene is switched on as its light, too; later ones change no setting.
bool setsNothing(const CommandSpec& command, const RequestContext& context) {
    return context.sky && command.name.starts_with("sky");
}

bool addsNote(const CommandSpec& command) {
    return command.id == CommandId::NoteAdd || command.id == CommandId::NoteAt;
}

void checkLocks(const CommandSpec& command, const RequestContext& context) {
    const Limits& limits = context.limits;
    const bool visitors = limits.visitorNotes && addsNote(command);
    if (command.browser == BrowserUse::Edit && limits.isLocked("edits") && !visitors)
        throw Refused("edits are locked here");
    if (command.id == CommandId::Defaults && !limits.locked.empty())
        throw Refused("some settings are locked; reset others one by one");
    if (setsNothing(command, context)) return;
    for (const std::string_view name : command.sets)
        if (limits.isLocked(name)) throw Refused(rtcore::say("{0} is locked", name));
}

void checkAmounts(const CommandSpec& command, const json& arguments, const RequestContext& context) {
    const bool adds = command.id == CommandId::LightAdd || command.id == CommandId::LightCopy;
    if (adds && context.lights >= kMaxLights)
        throw Refused(rtcore::say("there are {0} lights, the most that pages may have", context.lights));
    if (command.id != CommandId::Resolution) return;
    const double width = arguments[0].get<double>(), height = arguments[1].get<double>();
    if (width * height > static_cast<double>(context.limits.maxPixels))
        throw Refused(rtcore::say("{0} x {1} are more than {2} pixels", fmt::format("{}", width),
                                  fmt::format("{}", height), context.limits.maxPixels));
}

std::vector<std::string> wordsOf(const CommandSpec& command, const json& given,
                                 const RequestContext& context) {
    if (given.size() > command.arguments.size() &&
        (command.arguments.empty() || !command.arguments.back().repeats))
        throw Refused("there are too many arguments");
    std::vector<std::string> words;
    for (const json& each : given) {
        const std::size_t at = std::min(words.size(), command.arguments.size() - 1);
        const app::CommandArgument& argument = command.arguments[at];
        words.push_back(argument.type == app::ArgumentType::SettingValue
                            ? settingValueText(words.front(), each, context.limits)
                            : wordOf(argument, each, context));
    }
    try {
        app::checkArguments(command, words);
    } catch (const app::UsageError& error) {
        throw Refused(error.sentence());
    }
    return words;
}

std::string lineOf(const CommandSpec& command, std::span<const std::string> words) {
    const std::string arguments = app::joinWords(words);
    return std::string(command.name) + (arguments.empty() ? "" : " ") + arguments;
}

json argumentJson(const app::CommandArgument& argument) {
    json row{{"name", argument.name}};
    const bool numeric =
        argument.type == app::ArgumentType::Integer || argument.type == app::ArgumentType::Number;
    if (numeric && argument.minimum > -app::kMaxWhole) row["min"] = argument.minimum;
    if (numeric && argument.maximum < app::kMaxWhole) row["max"] = argument.maximum;
    if (!argument.words.empty()) row["words"] = app::wordsOf(argument);
    return row;
}

} // namespace

bool isRequest(const CommandSpec& command) {
    return command.browser == BrowserUse::Look || command.browser == BrowserUse::Move ||
           command.browser == BrowserUse::Edit;
}

PlannedCommand planRequest(const json& request, const RequestContext& context) {
    if (!request.is_object()) throw Refused("a request is an object");
    const CommandSpec& command = commandOf(request);
    checkLocks(command, context);
    const json& given = argumentsOf(request);
    const std::vector<std::string> words = wordsOf(command, given, context);
    checkAmounts(command, given, context);
    const bool step = command.id == CommandId::Undo || command.id == CommandId::Redo;
    if (step && !words.empty()) throw Refused("a page takes back its own last edit only");
    PlannedCommand planned{.id = command.id,
                           .line = lineOf(command, words),
                           .anyone = command.browser == BrowserUse::Look,
                           .edits = command.edits(),
                           .setting = command.id == CommandId::Set ? words.front() : std::string()};
    planned.note = addsNote(command);
    planned.named = planned.note && words.size() == command.arguments.size() && !words.back().empty();
    planned.anyone = planned.anyone || (planned.note && context.limits.visitorNotes);
    if (isAlso(request) && command.edits() && !planned.note) planned.line = "also " + planned.line;
    return planned;
}

json commandTableJson() {
    json rows = json::object();
    for (const CommandSpec& command : app::commandTable()) {
        if (!isRequest(command)) continue;
        json arguments = json::array();
        for (const app::CommandArgument& argument : command.arguments)
            arguments.push_back(argumentJson(argument));
        rows[std::string(command.name)] = std::move(arguments);
    }
    return rows;
}

} // namespace bridge
