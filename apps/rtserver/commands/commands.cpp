#include "rtserver/commands/commands.h"

#include "rtserver/commands/command_call.h"

#include "common/cli/command_line.h"
#include "common/commands/command_lookup.h"
#include "common/commands/quoting.h"

#include "rtcore/platform/sentence.h"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace rtserver {

namespace {

using Functions = std::array<Result (*)(const Call&), app::kCommands>;

const Functions& functions() {
    static const Functions all = [] {
        Functions table{};
        for (const auto group :
             {serverFunctions(), settingFunctions(), lightFunctions(), skyFunctions(), modelFunctions(),
              sectionFunctions(), planFunctions(), dimensionFunctions(), keptMeasureFunctions(),
              noteFunctions(), flightFunctions(), flightKeyFunctions(), variantFunctions(),
              measureFunctions(), cameraFunctions(), fileFunctions(), saveFunctions(), keyFunctions()}) {
            for (const CommandFunction& each : group) table[static_cast<std::size_t>(each.id)] = each.run;
        }
        return table;
    }();
    return all;
}

auto functionOf(app::CommandId id) { return functions()[static_cast<std::size_t>(id)]; }

/// The command without its values: what it is about, by its number or name.
std::string stepLabel(const app::CommandSpec& command, std::span<const std::string> arguments) {
    const std::string name(command.name);
    if (arguments.empty()) return name;
    const auto with = [&](const std::string& word) { return name + ' ' + app::joinWords(std::array{word}); };
    switch (command.arguments.front().type) {
    case app::ArgumentType::Setting:
    case app::ArgumentType::Integer:
        return with(arguments[0]);
    case app::ArgumentType::Path:
        return with(std::filesystem::path(arguments[0]).stem().string());
    default:
        return name;
    }
}

/// The commands that may precede an edit on its line: `by PERSON`, `also`, or `visitor`.
struct Prefixes {
    int person = 0;
    bool goesOn = false;
    bool visitor = false;
};

bool addsNote(app::CommandId id) { return id == app::CommandId::NoteAdd || id == app::CommandId::NoteAt; }

/// Cuts `visitor` off `words`; `found` is the command behind it then.
Prefixes takeVisitor(std::vector<std::string>& words, app::FoundCommand& found) {
    app::checkArguments(*found.command, std::span(words).subspan(found.words));
    words.erase(words.begin());
    found = app::findCommand(words);
    if (!addsNote(found.command->id))
        throw app::UsageError(rtcore::say("visitor is for 'note add' and 'note at'"));
    return {.visitor = true};
}

/// Cuts them off `words`; `found` is the command behind them then.
Prefixes takePrefixes(std::vector<std::string>& words, app::FoundCommand& found) {
    Prefixes prefixes;
    if (found.command->id == app::CommandId::Visitor) return takeVisitor(words, found);
    while (found.command->id == app::CommandId::Also || found.command->id == app::CommandId::By) {
        const app::CommandSpec& prefix = *found.command;
        const bool isBy = prefix.id == app::CommandId::By;
        app::checkArguments(prefix, std::span(words).subspan(found.words));
        if (isBy) prefixes.person = integer(words[1]);
        prefixes.goesOn = prefixes.goesOn || !isBy;
        words.erase(words.begin(), words.begin() + (isBy ? 2 : 1));
        found = app::findCommand(words);
        const bool again = found.command->id == app::CommandId::Also && isBy;
        if (!found.command->edits() && !again)
            throw app::UsageError(
                rtcore::say("{0} is for edits; {1} is none", prefix.name, found.command->name));
    }
    return prefixes;
}

// Work beside the server makes its change at its end.
Result runEdit(const Call& call, const app::CommandSpec& command, const Prefixes& prefixes) {
    const auto asStep = [&document = call.document(), label = stepLabel(command, call.arguments),
                         by = EditAuthor{call.client, prefixes.person}, goesOn = prefixes.goesOn](auto act) {
        Snapshot before = document.snapshot();
        auto result = act();
        document.keepStep(label, std::move(before), by, goesOn);
        return result;
    };
    Result result = asStep([&] { return functionOf(command.id)(call); });
    if (result.when != ReplyWhen::Beside) return result;
    result.work = [work = std::move(result.work), asStep]() -> Finish {
        return [finish = work(), asStep] { return asStep(finish); };
    };
    return result;
}

Result run(const Call& call, const app::CommandSpec& command, const Prefixes& prefixes) {
    if (command.needsScene && !call.document().ready()) return {.when = ReplyWhen::Again};
    const bool step = command.edits() && !prefixes.visitor;
    return step ? runEdit(call, command, prefixes) : functionOf(command.id)(call);
}

} // namespace

bool hasFunction(app::CommandId id) {
    using enum app::CommandId;
    return id == Also || id == By || id == Visitor || functionOf(id) != nullptr;
}

Result runCommand(std::string_view text, Workspace& state, Host& host, std::uint64_t client) {
    std::vector<std::string> words = app::splitWords(text);
    app::FoundCommand found = app::findCommand(words);
    const Prefixes prefixes = takePrefixes(words, found);
    const app::CommandSpec& command = *found.command;
    if (command.runner != app::Runner::Server)
        throw app::UsageError(rtcore::say("{0} is what CUI does itself, not the server", command.name));
    const std::span<const std::string> arguments = std::span(words).subspan(found.words);
    app::checkArguments(command, arguments);
    return run({state, host, arguments, client, prefixes.visitor}, command, prefixes);
}

Result runCommand(app::CommandId id, std::span<const std::string> arguments, Workspace& state, Host& host) {
    return run({state, host, arguments}, app::commandOf(id), {});
}

} // namespace rtserver
