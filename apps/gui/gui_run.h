/// A run of GUI, from its command line to its exit code.
#pragma once

#include "common/cli/command_line.h"
#include "common/process/exit_codes.h"

namespace gui {

/// Shows the window until it is closed, or until a signal asks to stop.
app::ExitCode runGui(const app::Arguments& arguments);

} // namespace gui
