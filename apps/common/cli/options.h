/// A program's command line as data: what the parser accepts, what --help and the manual page print, and what
/// shells complete come from the same table.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
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

/// Candidates for the last of `words`, for shells to complete; typing goes on behind one that ends with '='.
using Suggest = std::vector<std::string> (*)(std::span<const std::string> words);

struct Option {
    std::string name; ///< long spelling, without the dashes
    char letter = 0;  ///< short spelling; 0 = none
    std::vector<std::string> thesis =
        {}; ///< spellings of one dash and several letters, with the dash: "-aon"
    std::vector<std::string> formerly = {}; ///< long names that it had before: taken, but told nowhere
    ValueKind value = ValueKind::None;
    std::string argument = {}; ///< how the help calls the value
    std::string help = {};     ///< sentence without a full stop; [] at its end hold the default
    std::string more = {};     ///< further sentences for docs/manual.md, which has code in backquotes
    double minimum = std::numeric_limits<double>::lowest();
    double maximum = std::numeric_limits<double>::max();
    std::vector<std::string> choices = {};
    bool answers = false; ///< answers a question and exits, so that the positionals may be missing
    std::vector<std::string> files = {}; ///< with the argument FILE: usual extensions; none = any
    Suggest suggest = nullptr;
};

/// A command: "key press KEY", "light N on|off", "export camera FILE [WIDTH HEIGHT]". Small letters are typed
/// as they are, capitals stand for something, and '|' parts what may stand in one place.
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
    bool repeats = false;                ///< stands for one or more; the last positional only
    bool optional = false;               ///< may be missing; the last positional only
    std::vector<std::string> files = {}; ///< usual extensions; none = any
};

/// The meaning of a word in capitals in the labels of commands, for completion. FILE needs none.
struct Operand {
    std::string command; ///< empty = in every command that has no row of its own
    std::string name;
    std::vector<std::string> files = {}; ///< of a FILE: usual extensions
    Suggest suggest = nullptr;
    std::string program = {}; ///< from here on all words are options of this program
};

struct Example {
    std::string command;
    std::string meaning;
};

/// An optional part that a program was built with or without, for --version.
struct Feature {
    std::string name;
    bool present;
    std::string without; ///< what is missing then
};

struct ProgramSpec {
    std::string name;
    std::string purpose; ///< one or two sentences
    std::vector<Positional> positionals;
    std::vector<OptionGroup> groups;
    std::vector<Example> examples;
    std::vector<Operand> operands = {};
    std::vector<HelpWord> environment = {}, files = {}; ///< for the manual page
    std::vector<Feature> features = {};                 ///< beside those of all programs

    const Option* find(const std::string& longName) const;
    std::size_t requiredPositionals() const;
};

/// The same table with what every program has at its end: --help and --version. -h is help unless it is
/// taken.
ProgramSpec withStandardOptions(ProgramSpec spec);

} // namespace app
