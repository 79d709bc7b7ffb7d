#include "rtserver/commands.h"

#include "rtserver/command_call.h"

#include "common/cli/command_line.h"
#include "common/commands/command_lookup.h"
#include "common/commands/quoting.h"

#include <array>
#include <cstddef>
#include <vector>

namespace rtserver {

namespace {

using Functions = std::array<Result (*)(const Call&), app::kCommands>;

const Functions& functions() {
    static const Functions all = [] {
        Functions table{};
        for (const auto group :
             {serverFunctions(), settingFunctions(), cameraFunctions(), fileFunctions(), keyFunctions()}) {
            for (const CommandFunction& each : group) table[static_cast<std::size_t>(each.id)] = each.run;
        }
        return table;
    }();
    return all;
}

} // namespace

bool hasFunction(app::CommandId id) { return functions()[static_cast<std::size_t>(id)] != nullptr; }

Result runCommand(std::string_view text, ServerState& state, Host& host) {
    const std::vector<std::string> words = app::splitWords(text);
    const app::FoundCommand found = app::findCommand(words);
    const app::CommandSpec& command = *found.command;
    if (command.runner != app::Runner::Server)
        throw app::UsageError(std::string(command.name) + " is what CUI does itself, not the server");
    const std::span<const std::string> arguments = std::span(words).subspan(found.words);
    app::checkArguments(command, arguments);
    if (command.needsScene && !state.ready()) return {.when = ReplyWhen::Again};
    return functions()[static_cast<std::size_t>(command.id)]({state, host, arguments});
}

app::CommandEffect effectOf(std::string_view text) {
    try {
        return app::findCommand(app::splitWords(text)).command->effect;
    } catch (const app::UsageError&) {
        return app::CommandEffect::Tells;
    }
}

} // namespace rtserver
