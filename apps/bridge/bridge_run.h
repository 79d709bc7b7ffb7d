/// A run of RTBridge, from its command line to its exit code.
#pragma once

#include "common/cli/command_line.h"
#include "common/process/exit_codes.h"

namespace bridge {

/// Serves until a signal asks to stop, or the server that --start started ends. SIGUSR1 renews the tokens.
app::ExitCode runBridge(const app::Arguments& arguments);

} // namespace bridge
