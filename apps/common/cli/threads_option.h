/// The option --threads of programs that render or build.
#pragma once

#include "common/cli/command_line.h"

namespace app {

Option threadsOption();

/// The number that --threads asks for, else that of app::threadCount(); 0: all cores.
int threadsOf(const Arguments& arguments);

} // namespace app
