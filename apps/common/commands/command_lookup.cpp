#include "common/commands/command_lookup.h"

#include "common/cli/command_line.h"
#include "common/commands/quoting.h"

#include "rtcore/platform/sentence.h"
#include "rtcore/settings/nearest_name.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>

namespace app {

namespace {

using rtcore::say;
using rtcore::Sentence;

constexpr std::size_t kMaxWords = 3; ///< of a name

std::string shortNumber(double value) { return fmt::format("{:.9g}", value); }

// "a number from 0 to 1", "a whole number, at least 1".
Sentence kindOf(const CommandArgument& argument) {
    const bool whole = argument.type == ArgumentType::Integer;
    const Sentence kind = say(whole ? "a whole number" : "a number");
    const double limit = whole ? kMaxWhole : kMaxNumber;
    const std::string min = shortNumber(argument.minimum), max = shortNumber(argument.maximum);
    if (argument.open) return say("{0} above {1} and below {2}", kind, min, max);
    if (argument.maximum < limit) return say("{0} from {1} to {2}", kind, min, max);
    return argument.minimum > -limit ? say("{0}, at least {1}", kind, min) : kind;
}

Sentence rangeOf(const CommandArgument& argument) {
    const bool numeric = argument.type == ArgumentType::Integer || argument.type == ArgumentType::Number;
    std::optional<Sentence> range;
    if (numeric) range = kindOf(argument);
    for (const std::string_view word : wordsOf(argument))
        range = range ? say("{0} or {1}", *range, word) : Sentence(word);
    return range.value_or(Sentence());
}

bool holds(const CommandArgument& argument, double value) {
    return argument.open ? value > argument.minimum && value < argument.maximum
                         : value >= argument.minimum && value <= argument.maximum;
}

bool takes(const CommandArgument& argument, const std::string& text) {
    const std::vector<std::string_view> words = wordsOf(argument);
    if (std::find(words.begin(), words.end(), text) != words.end()) return true;
    switch (argument.type) {
    case ArgumentType::Choice:
        return false;
    case ArgumentType::Integer: {
        const std::optional<std::int64_t> value = parseInteger(text);
        return value && holds(argument, static_cast<double>(*value));
    }
    case ArgumentType::Number: {
        const std::optional<double> value = parseNumber(text);
        return value && holds(argument, *value);
    }
    default:
        return true;
    }
}

bool mayCount(const CommandSpec& command, std::size_t count) {
    const std::vector<CommandArgument>& all = command.arguments;
    if (!all.empty() && all.back().repeats && count + 1 >= all.size()) return true;
    return count == all.size() || (count < all.size() && all[count].optional);
}

/// Words before the edit, with its arguments, of a command that precedes one; 0: it precedes none.
std::size_t wordsOfPrefix(CommandId id) {
    if (id == CommandId::By) return 2;
    return id == CommandId::Also || id == CommandId::Visitor ? 1 : 0;
}

[[noreturn]] void refuseName(std::span<const std::string> words) {
    std::vector<std::string_view> names;
    std::string longer;
    for (const CommandSpec& command : commandTable()) {
        names.push_back(command.name);
        if (command.name.starts_with(words[0] + " "))
            longer.append(longer.empty() ? "" : ", ").append(command.name);
    }
    const std::string two = words.size() > 1 ? words[0] + " " + words[1] : words[0];
    const bool near = words.size() > 1 && !rtcore::nearestName(two, names).empty();
    if (!longer.empty() && !near)
        throw UsageError(
            say("{0} is the beginning of several commands: {1}", rtcore::inQuotes(words[0]), longer));
    throw UsageError(rtcore::unknownNameMessage(rtcore::form("command"), two, names));
}

} // namespace

FoundCommand findCommand(std::span<const std::string> words) {
    if (words.empty()) throw UsageError("the command is empty");
    for (std::size_t used = std::min(words.size(), kMaxWords); used > 0; --used) {
        std::string name = words[0];
        for (std::size_t i = 1; i < used; ++i) name += " " + words[i];
        for (const CommandSpec& command : commandTable()) {
            if (command.name == name) return {&command, used};
        }
    }
    refuseName(words);
}

void checkArguments(const CommandSpec& command, std::span<const std::string> arguments) {
    if (!mayCount(command, arguments.size())) {
        const std::string label = argumentsLabel(command);
        throw UsageError(label.empty() ? say("{0} takes no arguments", command.name)
                                       : say("{0} takes {1}", command.name, label));
    }
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const CommandArgument& argument = command.arguments[std::min(i, command.arguments.size() - 1)];
        if (takes(argument, arguments[i])) continue;
        const std::string given = rtcore::inQuotes(arguments[i]);
        throw UsageError(argument.name.empty()
                             ? say("{0} takes {1}, not {2}", command.name, rangeOf(argument), given)
                             : say("{0} takes {1} for {3}, not {2}", command.name, rangeOf(argument), given,
                                   argument.name));
    }
}

CommandEffect effectOf(std::string_view line) {
    try {
        const std::vector<std::string> words = splitWords(line);
        std::span<const std::string> rest(words);
        const CommandSpec* command = findCommand(rest).command;
        while (const std::size_t before = wordsOfPrefix(command->id)) {
            rest = rest.subspan(std::min(before, rest.size()));
            command = findCommand(rest).command;
        }
        return command->effect;
    } catch (const UsageError&) {
        return CommandEffect::Tells;
    }
}

} // namespace app
