/// The common main() of all programs: signals, standard options, and the one place that catches exceptions.
#pragma once

#include "common/cli/command_line.h"
#include "common/cli/options.h"
#include "common/process/exit_codes.h"

#include <functional>

namespace app {

/// The body of main(): parses the command line by `spec` (which gains --help and --version), answers these
/// two and the empty command line, runs `work`, prints "Program: message" on stderr for whatever it throws.
/// Returns the exit code. Call it once, from the main thread.
int runProgram(int argc, const char* const* argv, const ProgramSpec& spec,
               const std::function<ExitCode(const Arguments&)>& work);

} // namespace app
