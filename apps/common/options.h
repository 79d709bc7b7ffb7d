/// A program's command line as data: what the parser accepts and what --help prints come from the same table.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace app {

enum class ValueKind {
    None,    ///< a switch
    Text,    ///< anything that is not empty
    Integer, ///< decimal, in [minimum, maximum]
    Number,  ///< finite, in [minimum, maximum]
    Choice,  ///< one of `choices`
};

struct Option {
    std::string name; ///< long spelling, without the dashes
    char letter = 0;  ///< short spelling; 0 = none
    std::vector<std::string> thesis =
        {}; ///< spellings of one dash and several letters, with the dash: "-aon"
    ValueKind value = ValueKind::None;
    std::string argument = {}; ///< how the help calls the value
    std::string help = {};     ///< sentence without a full stop
    double minimum = std::numeric_limits<double>::lowest();
    double maximum = std::numeric_limits<double>::max();
    std::vector<std::string> choices = {};
    bool answers = false; ///< answers a question and exits, so that the positionals may be missing
};

/// A word that is no option, explained in the help: a command.
struct HelpWord {
    std::string label, help;
};

struct OptionGroup {
    std::string title;
    std::vector<Option> options;
    std::vector<HelpWord> words = {};
};

/// An argument without a dash. All are required but the last, which may be optional: then
/// the program may be run without any argument.
struct Positional {
    std::string name; ///< in capitals
    std::string help;
    bool repeats = false; ///< stands for one or more; the last positional only
    bool optional = false; ///< may be missing; the last positional only
};

struct Example {
    std::string command;
    std::string meaning;
};

struct ProgramSpec {
    std::string name;
    std::string purpose; ///< one or two sentences
    std::vector<Positional> positionals;
    std::vector<OptionGroup> groups;
    std::vector<Example> examples;

    const Option* find(const std::string& longName) const;
    std::size_t requiredPositionals() const;
};

/// The same table with what every program has at its end: --help and --version. -h is help unless it is
/// taken.
ProgramSpec withStandardOptions(ProgramSpec spec);

} // namespace app
