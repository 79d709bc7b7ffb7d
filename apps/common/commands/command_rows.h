/// How rows of the table of commands are written, and the groups of rows in their order.
#pragma once

#include "common/commands/command_table.h"

#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace app {

using ArgumentList = std::vector<CommandArgument>;

inline CommandArgument whole(std::string_view name, double minimum = -kMaxWhole, double maximum = kMaxWhole) {
    return {.name = name, .type = ArgumentType::Integer, .minimum = minimum, .maximum = maximum};
}

inline CommandArgument number(std::string_view name, double minimum = -kMaxNumber,
                              double maximum = kMaxNumber) {
    return {.name = name, .type = ArgumentType::Number, .minimum = minimum, .maximum = maximum};
}

/// A number between two that it is not.
inline CommandArgument between(std::string_view name, double minimum, double maximum) {
    return {.name = name, .type = ArgumentType::Number, .minimum = minimum, .maximum = maximum, .open = true};
}

inline CommandArgument choice(std::string words) {
    return {.type = ArgumentType::Choice, .words = std::move(words)};
}

/// One of a table's names: `nameOf` of a row, itself where the table holds names alone.
template <typename Table, typename NameOf = std::identity>
CommandArgument choiceOf(const Table& table, NameOf nameOf = {}) {
    std::string words;
    for (const auto& row : table)
        words.append(words.empty() ? "" : "|").append(std::string_view(std::invoke(nameOf, row)));
    return choice(std::move(words));
}

inline CommandArgument path(std::vector<std::string> files = {}) {
    return {.name = "FILE", .type = ArgumentType::Path, .files = std::move(files)};
}

inline CommandArgument text(std::string_view name, ArgumentType type = ArgumentType::Text) {
    return {.name = name, .type = type};
}

inline CommandArgument orElse(CommandArgument argument, std::string words) {
    argument.words = std::move(words);
    return argument;
}

inline CommandArgument maybe(CommandArgument argument) {
    argument.optional = true;
    return argument;
}

inline CommandArgument manyOf(CommandArgument argument) {
    argument.repeats = true;
    return argument;
}

inline ArgumentList numbers(std::initializer_list<std::string_view> names) {
    ArgumentList all;
    for (const std::string_view name : names) all.push_back(number(name));
    return all;
}

inline ArgumentList operator+(ArgumentList first, const ArgumentList& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

std::vector<CommandSpec> shellCommands();
std::vector<CommandSpec> serverCommands();
std::vector<CommandSpec> settingCommands();
std::vector<CommandSpec> editCommands();
std::vector<CommandSpec> cameraCommands();
std::vector<CommandSpec> fileCommands();
std::vector<CommandSpec> lightCommands();
std::vector<CommandSpec> skyCommands();
std::vector<CommandSpec> bookmarkCommands();
std::vector<CommandSpec> modelCommands();
std::vector<CommandSpec> sectionCommands();
std::vector<CommandSpec> planCommands();
std::vector<CommandSpec> dimensionCommands();
std::vector<CommandSpec> keptMeasureCommands();
std::vector<CommandSpec> noteCommands();
std::vector<CommandSpec> flightCommands();
std::vector<CommandSpec> variantCommands();
std::vector<CommandSpec> measureCommands();
std::vector<CommandSpec> keyCommands();

} // namespace app
