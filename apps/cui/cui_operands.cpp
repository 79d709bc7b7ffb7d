#include "cui/cui_operands.h"

#include "common/commands/command_table.h"
#include "common/settings/setting_suggestions.h"

#include "ipc/endpoint/instances.h"

namespace cui {

namespace {

using Words = std::span<const std::string>;

std::vector<std::string> suggestSettings(Words /*words*/) { return app::settingNames(); }

std::vector<std::string> suggestValues(Words words) {
    return words.size() < 2 ? std::vector<std::string>() : app::settingValues(words[words.size() - 2]);
}

app::Suggest suggestionsOf(app::ArgumentType type) {
    switch (type) {
    case app::ArgumentType::Setting:
        return suggestSettings;
    case app::ArgumentType::SettingValue:
        return suggestValues;
    case app::ArgumentType::Key:
        return suggestKeys;
    case app::ArgumentType::Action:
        return suggestActions;
    default:
        return nullptr;
    }
}

} // namespace

std::vector<std::string> suggestInstances(Words /*words*/) {
    std::vector<std::string> names;
    for (const ipc::Instance& each : ipc::listInstances()) names.push_back(each.name);
    return names;
}

std::vector<std::string> suggestKeys(Words /*words*/) {
    return {"space", "left",     "right",  "up",        "down",   "shift",    "control",
            "alt",   "capslock", "tab",    "pageup",    "return", "pagedown", "home",
            "end",   "insert",   "delete", "backspace", "escape"};
}

std::vector<std::string> suggestActions(Words /*words*/) {
    return {"forward",    "back",        "left",        "right",
            "up",         "down",        "turnLeft",    "turnRight",
            "turnUp",     "turnDown",    "jump",        "crouch",
            "toggleWalk", "toggleBloom", "toggleLight", "selectEnvironment",
            "sprint",     "crawl"};
}

std::vector<app::Operand> operands() {
    std::vector<app::Operand> all;
    for (const app::CommandSpec& command : app::commandTable()) {
        for (const app::CommandArgument& argument : command.arguments) {
            const bool path = argument.type == app::ArgumentType::Path;
            const app::Suggest suggest = suggestionsOf(argument.type);
            if (path || suggest != nullptr)
                all.push_back(
                    {std::string(command.name), std::string(argument.name), argument.files, suggest});
        }
    }
    all.push_back({.command = "render", .name = "OPTION", .program = "Renderer"});
    return all;
}

} // namespace cui
