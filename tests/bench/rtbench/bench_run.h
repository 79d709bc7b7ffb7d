/// A run of rtbench, from its command line to its exit code.
#pragma once

#include "common/cli/command_line.h"
#include "common/process/exit_codes.h"

namespace rtbench {

/// Loads, races, prints. Failed when we and Embree's robust mode hit different things with many rays.
app::ExitCode runBench(const app::Arguments& arguments);

} // namespace rtbench
