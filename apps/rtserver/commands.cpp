#include "rtserver/commands.h"

#include "rtserver/command_call.h"

#include "common/cli/command_line.h"
#include "common/commands/quoting.h"
#include "common/process/ipc_exit_code.h"

#include "ipc/platform/error.h"

#include "rtcore/platform/error.h"
#include "rtcore/settings/nearest_name.h"

#include <algorithm>
#include <new>
#include <stdexcept>
#include <vector>

namespace rtserver {

namespace {

constexpr std::size_t kMostWords = 3; ///< of a command's name

const std::vector<Command>& allCommands() {
    static const std::vector<Command> commands = [] {
        std::vector<Command> all;
        for (const auto group :
             {serverCommands(), settingCommands(), cameraCommands(), fileCommands(), keyCommands()})
            all.insert(all.end(), group.begin(), group.end());
        return all;
    }();
    return commands;
}

[[noreturn]] void refuseName(const std::string& name) {
    std::vector<std::string_view> names;
    for (const Command& command : allCommands()) names.push_back(command.name);
    throw app::UsageError(rtcore::unknownNameMessage("command", name, names));
}

// More words go before fewer.
const Command& find(const std::vector<std::string>& words, std::size_t& used) {
    if (words.empty()) throw app::UsageError("the command is empty");
    for (used = std::min(words.size(), kMostWords); used > 0; --used) {
        std::string name = words[0];
        for (std::size_t i = 1; i < used; ++i) name += " " + words[i];
        for (const Command& command : allCommands()) {
            if (command.name == name) return command;
        }
    }
    refuseName(words.size() > 1 ? words[0] + " " + words[1] : words[0]);
}

app::ExitCode exitCodeOf(const std::exception& error) {
    if (const auto* file = dynamic_cast<const rtcore::FileError*>(&error)) return app::exitCodeOf(file->kind);
    if (dynamic_cast<const std::invalid_argument*>(&error) != nullptr) return app::ExitCode::Usage;
    if (dynamic_cast<const app::UsageError*>(&error) != nullptr) return app::ExitCode::Usage;
    if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return app::ExitCode::TryAgain;
    if (const auto* link = dynamic_cast<const ipc::Error*>(&error)) return app::exitCodeOf(link->problem);
    return app::ExitCode::Failed;
}

} // namespace

Result runCommand(std::string_view text, Session& session, Host& host) {
    const std::vector<std::string> words = app::splitWords(text);
    std::size_t used = 0;
    const Command& command = find(words, used);
    const std::span<const std::string> arguments = std::span(words).subspan(used);
    if (arguments.size() < command.least || arguments.size() > command.most) {
        const std::string takes = command.most == 0 ? "no arguments" : std::string(command.arguments);
        throw app::UsageError(std::string(command.name) + " takes " + takes);
    }
    if (command.needsScene && !session.ready()) return {.turn = Turn::Again};
    return command.run({session, host, arguments});
}

Effect effectOf(std::string_view text) {
    try {
        std::size_t used = 0;
        return find(app::splitWords(text), used).effect;
    } catch (const app::UsageError&) {
        return Effect::Tells;
    }
}

std::string failureText(const std::exception& error) {
    const bool memory = dynamic_cast<const std::bad_alloc*>(&error) != nullptr;
    return std::to_string(static_cast<int>(exitCodeOf(error))) + " " +
           (memory ? "not enough memory" : error.what());
}

} // namespace rtserver
