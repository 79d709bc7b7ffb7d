/// The option --isa of programs that trace rays.
#pragma once

#include "common/cli/command_line.h"

namespace app {

Option isaOption();

/// Uses the instruction set that --isa names, if it is given. Throws UsageError when the processor lacks it.
void useIsa(const Arguments& arguments);

} // namespace app
