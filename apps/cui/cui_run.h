/// A run of CUI, from its command line to its exit code.
#pragma once

#include "common/cli/command_line.h"
#include "common/process/exit_codes.h"

namespace cui {

/// Runs one command, or a script of them. The server's errors go to stderr, with the exit code that it names;
/// TryAgain when there is no server or no answer in time.
app::ExitCode runCui(const app::Arguments& arguments);

} // namespace cui
