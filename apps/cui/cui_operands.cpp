#include "cui/cui_operands.h"

#include "common/cli/file_notes.h"
#include "common/settings/setting_suggestions.h"

#include "ipc/endpoint/instances.h"

namespace cui {

namespace {

using Words = std::span<const std::string>;

std::vector<std::string> suggestSettings(Words /*words*/) { return app::settingNames(); }

std::vector<std::string> suggestValues(Words words) {
    return words.size() < 2 ? std::vector<std::string>() : app::settingValues(words[words.size() - 2]);
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
    return {{.command = "set", .name = "NAME", .suggest = suggestSettings},
            {.command = "set", .name = "VALUE", .suggest = suggestValues},
            {.command = "get", .name = "NAME", .suggest = suggestSettings},
            {.command = "load camera", .name = "FILE", .files = {"cam"}},
            {.command = "load scene", .name = "FILE", .files = app::sceneExtensions()},
            {.command = "load set", .name = "FILE", .files = {"set"}},
            {.command = "export camera", .name = "FILE", .files = {"cam"}},
            {.command = "export scene", .name = "FILE", .files = {"scn"}},
            {.command = "export video start", .name = "FILE", .files = {"lst", "txt"}},
            {.command = "play", .name = "FILE", .files = {"lst", "txt"}},
            {.command = "bind", .name = "ACTION", .suggest = suggestActions},
            {.command = "render", .name = "OPTION", .program = "Renderer"},
            {.command = "", .name = "KEY", .suggest = suggestKeys}};
}

} // namespace cui
