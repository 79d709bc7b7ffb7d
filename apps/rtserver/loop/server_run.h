/// A run of RTServer, from its command line to its exit code.
#pragma once

#include "common/cli/command_line.h"
#include "common/process/exit_codes.h"

namespace rtserver {

/// Serves until a command or a signal ends it. TryAgain when another server has the instance.
app::ExitCode runServer(const app::Arguments& arguments);

/// Ends the process, also while a thread waits for a file that does not answer: no file is left half written.
[[noreturn]] void endProcess(int exitCode);

} // namespace rtserver
