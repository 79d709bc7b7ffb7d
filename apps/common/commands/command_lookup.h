/// A line of words, looked up in the table of commands and held against it.
#pragma once

#include "common/commands/command_table.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace app {

/// The row for a line of words, and how many of them are its name.
struct FoundCommand {
    const CommandSpec* command;
    std::size_t words;
};

/// The longest name that the line begins with. Throws UsageError, which names the nearest command, or the
/// words that may follow.
FoundCommand findCommand(std::span<const std::string> words);

/// Number, type and range of what stands behind the name. Throws UsageError, which names the argument and
/// what it takes. What only a server can know - keys, settings, files - it does not look at.
void checkArguments(const CommandSpec& command, std::span<const std::string> arguments);

/// The effect of a line as a client sends it: that of the edit behind `also`, `by PERSON` and `visitor`. A
/// wrong line Tells what is wrong with it. Throws nothing but std::bad_alloc.
CommandEffect effectOf(std::string_view line);

} // namespace app
