#include "common/commands/command_table.h"

#include <algorithm>

namespace app {

namespace {

std::string labelOf(const CommandArgument& argument) {
    std::string label(argument.name);
    if (!argument.words.empty()) label.append(label.empty() ? "" : "|").append(argument.words);
    return label + (argument.repeats ? "..." : "");
}

} // namespace

std::string argumentsLabel(const CommandSpec& command) {
    std::string label;
    std::size_t open = 0;
    for (const CommandArgument& argument : command.arguments) {
        if (!label.empty()) label += ' ';
        if (argument.optional) {
            label += '[';
            ++open;
        }
        label += labelOf(argument);
    }
    return label.append(open, ']');
}

std::string commandLabel(const CommandSpec& command) {
    const std::string arguments = argumentsLabel(command);
    return std::string(command.name) + (arguments.empty() ? "" : " ") + arguments;
}

std::vector<std::string_view> wordsOf(const CommandArgument& argument) {
    std::vector<std::string_view> words;
    std::string_view rest = argument.words;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('|'), rest.size());
        words.push_back(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return words;
}

} // namespace app
