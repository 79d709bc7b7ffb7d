/// CUI's command line and its commands, as data.
#pragma once

#include "common/cli/options.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cui {

enum class Doer {
    Server, ///< the line is sent to the server
    Local   ///< CUI does it itself
};

struct CommandSpec {
    std::string_view name; ///< one word to three
    std::string_view arguments;
    std::string_view help;
    Doer doer = Doer::Server;
    bool path = false; ///< the first argument is one: it is made absolute before it is sent
};

std::span<const CommandSpec> commands();

/// The row for a line of words, and how many of them are its name. Throws app::UsageError.
struct FoundCommand {
    const CommandSpec* spec;
    std::size_t words;
};
FoundCommand findCommand(std::span<const std::string> words);

const app::ProgramSpec& cuiSpec();

} // namespace cui
