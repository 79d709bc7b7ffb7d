/// The texts that a program prints about itself, made from its table of options.
#pragma once

#include "common/cli/options.h"

#include <span>
#include <string>

namespace app {

/// The text of --help: usage, purpose, arguments, options by group, examples, exit codes; GNU layout, 79
/// columns.
std::string helpText(const ProgramSpec& spec);

/// The text that a program prints without arguments: usage, and where to find more.
std::string briefText(const ProgramSpec& spec);

/// The text of --version: name, version, licence, and which optional parts this build has.
std::string versionText(const ProgramSpec& spec);

/// "0.1.0"
std::string suiteVersion();

/// The meaning of each exit code: the number, and the words.
std::span<const HelpWord> exitCodeNotes();

/// "-a, --antialiasing=N": all spellings of an option as the help lists them.
std::string spellings(const Option& option);

} // namespace app
