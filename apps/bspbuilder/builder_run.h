/// A run of BSPBuilder, from its command line to its exit code.
#pragma once

#include "common/cli/command_line.h"
#include "common/process/exit_codes.h"

namespace bspbuilder {

/// Imports the model, builds the tree, writes the file, reports. The output is the old file, or none, until
/// all of the new one is written, however the program ends.
app::ExitCode runBuilder(const app::Arguments& arguments);

} // namespace bspbuilder
