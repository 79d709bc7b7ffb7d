/// What surrounds every program: signals, the standard options, and the one place that catches exceptions.
#pragma once

#include "common/command_line.h"
#include "common/exit_codes.h"
#include "common/options.h"

#include "rtcore/platform/error.h"

#include <functional>
#include <string_view>

namespace app {

/// The exit code that tells of such a failure.
ExitCode exitCodeOf(rtcore::FailureKind kind);

/// The body of main(): parses the command line by `spec` (which gains --help and --version), answers these
/// two and the empty command line, runs `work`, prints "Program: message" on stderr for whatever it throws.
/// Returns the exit code. Call it once, from the main thread.
int runProgram(int argc, const char* const* argv, const ProgramSpec& spec,
               const std::function<ExitCode(const Arguments&)>& work);

/// "Program: text" and a line end, on stderr, in one write. Names in the text may come from anywhere: control
/// characters and what is no UTF-8 are shown as `\xNN`. Safe from any thread.
void printMessage(std::string_view program, std::string_view text) noexcept;

} // namespace app
