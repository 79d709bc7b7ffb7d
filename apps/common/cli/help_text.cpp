#include "common/cli/help_text.h"

#include <algorithm>
#include <array>
#include <sstream>

namespace app {

namespace {

constexpr std::size_t kColumns = 79;
constexpr std::size_t kTextColumn = 29;

// Breaks at spaces; every line begins with `indent` spaces except the first, which continues at `column`.
std::string wrap(const std::string& text, std::size_t indent, std::size_t column) {
    std::istringstream words(text);
    std::string result, word;
    std::size_t used = column;
    bool first = true;
    while (words >> word) {
        if (!first && used + 1 + word.size() > kColumns) {
            result += "\n" + std::string(indent, ' ');
            used = indent;
            first = true;
        }
        result += (first ? "" : " ") + word;
        used += word.size() + (first ? 0 : 1);
        first = false;
    }
    return result;
}

std::string entry(const std::string& label, const std::string& text) {
    std::string line = "  " + label;
    if (line.size() + 2 > kTextColumn) {
        line += "\n" + std::string(kTextColumn, ' ');
    } else {
        line.resize(kTextColumn, ' ');
    }
    return line + wrap(text, kTextColumn, kTextColumn) + "\n";
}

std::string usageLine(const ProgramSpec& spec) {
    std::string line = "Usage: " + spec.name;
    for (const Positional& positional : spec.positionals) {
        const std::string name = positional.name + (positional.repeats ? "..." : "");
        line += positional.optional ? " [" + name + "]" : " " + name;
    }
    return line + " [OPTION]...\n";
}

} // namespace

std::span<const HelpWord> exitCodeNotes() {
    static const std::array<HelpWord, 10> notes = {{
        {"0", "done"},
        {"1", "failed for a reason without a code of its own"},
        {"2", "the command line is wrong"},
        {"65", "the content of a file is wrong"},
        {"66", "an input is missing or cannot be read"},
        {"73", "an output cannot be written, or the shared name is another user's"},
        {"75", "a resource is short for the moment, try again"},
        {"129", "stopped by SIGHUP"},
        {"130", "stopped by SIGINT (Ctrl-C)"},
        {"143", "stopped by SIGTERM"},
    }};
    return notes;
}

const Option* ProgramSpec::find(const std::string& longName) const {
    for (const OptionGroup& group : groups) {
        for (const Option& option : group.options) {
            if (option.name == longName) return &option;
        }
    }
    return nullptr;
}

std::size_t ProgramSpec::requiredPositionals() const {
    const bool optional = !positionals.empty() && positionals.back().optional;
    return positionals.size() - (optional ? 1 : 0);
}

ProgramSpec withStandardOptions(ProgramSpec spec) {
    bool taken = false;
    for (const OptionGroup& group : spec.groups) {
        for (const Option& option : group.options) taken = taken || option.letter == 'h';
    }
    Option help{.name = "help", .thesis = {"-help"}, .help = "display this help and exit", .answers = true};
    if (!taken) help.letter = 'h';
    Option version{.name = "version",
                   .help = "display version and build features, and exit",
                   .more =
                       "The features are OpenMP, ImageMagick, OpenEXR and the vector code of this processor",
                   .answers = true};
    spec.groups.push_back({"About", {std::move(help), std::move(version)}});
    return spec;
}

std::string spellings(const Option& option) {
    std::string text;
    if (option.letter != 0) text += std::string("-") + option.letter + ", ";
    for (const std::string& spelling : option.thesis) text += spelling + ", ";
    if (text.empty()) text = "    ";
    text += "--" + option.name;
    if (option.value != ValueKind::None) text += "=" + option.argument;
    return text;
}

std::string helpText(const ProgramSpec& spec) {
    std::string text = usageLine(spec) + wrap(spec.purpose, 0, 0) + "\n";
    if (!spec.positionals.empty()) text += "\nArguments:\n";
    for (const Positional& positional : spec.positionals) text += entry(positional.name, positional.help);
    for (const OptionGroup& group : spec.groups) {
        text += "\n" + group.title + ":\n";
        for (const HelpWord& word : group.words) text += entry(word.label, word.help);
        for (const Option& option : group.options) text += entry(spellings(option), option.help);
    }
    if (!spec.examples.empty()) text += "\nExamples:\n";
    for (const Example& example : spec.examples) {
        text += "  " + example.command + "\n        " + wrap(example.meaning, 8, 8) + "\n";
    }
    text += "\nExit status:\n";
    for (const HelpWord& code : exitCodeNotes()) {
        std::string number = code.label;
        number.resize(5, ' ');
        text += "  " + number + code.help + "\n";
    }
    return text;
}

std::string briefText(const ProgramSpec& spec) {
    std::string text = usageLine(spec) + wrap(spec.purpose, 0, 0) + "\n\n";
    for (const Positional& positional : spec.positionals) text += entry(positional.name, positional.help);
    return text + "\nTry '" + spec.name + " --help' for all options.\n";
}

} // namespace app
