/// Reads a command line by a table of options (options.h).
#pragma once

#include "common/cli/options.h"

#include "rtcore/platform/sentence.h"

#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// The command line is wrong: runProgram() adds "Try 'Program --help'." and returns ExitCode::Usage.
class UsageError : public std::runtime_error, public rtcore::Worded {
  public:
    explicit UsageError(const rtcore::Sentence& why) : std::runtime_error(why.english()), Worded(why) {}
};

/// One option as it was given; `name` is the long spelling, whichever was used.
struct Occurrence {
    std::string name;
    std::string value; ///< empty for switches
};

/// A command line that fits its table: every value has the type and range that the table asks for.
/// An option given twice counts by its last value, unless the program reads all().
class Arguments {
  public:
    Arguments(std::vector<Occurrence> options, std::vector<std::string> positionals)
        : options_(std::move(options)), positionals_(std::move(positionals)) {}

    const std::vector<Occurrence>& options() const { return options_; } ///< in the order of the command line
    const std::vector<std::string>& positionals() const { return positionals_; }

    bool has(std::string_view name) const { return text(name).has_value(); }
    std::optional<std::string> text(std::string_view name) const;
    std::optional<std::int64_t> integer(std::string_view name) const;
    std::optional<double> number(std::string_view name) const;
    std::vector<std::string> all(std::string_view name) const;

  private:
    std::vector<Occurrence> options_;
    std::vector<std::string> positionals_;
};

/// Accepts --name=value, --name value, -xvalue, -x value, the thesis' spellings, and `--`, after which
/// nothing is an option. A value in a word of its own does not begin with "--" (write --name=--value). Names
/// are never guessed from a part. With --help or --version given, positionals may be missing. Throws
/// UsageError.
Arguments parseCommandLine(const ProgramSpec& spec, std::span<const std::string> arguments);

/// The whole of `text` as a finite number, or nothing; the decimal point is a point in every locale.
std::optional<double> parseNumber(std::string_view text);
std::optional<std::int64_t> parseInteger(std::string_view text);

} // namespace app
