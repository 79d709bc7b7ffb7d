/// The option --parent of programs that serve the one that started them, and are of no use without it.
#pragma once

#include "common/cli/command_line.h"
#include "common/cli/options.h"

#include <cstdint>

namespace app {

/// --parent=PID.
Option parentOption();

/// The process that --parent names; 0 without it. For stopWithParent() (process/parent.h).
std::int64_t parentOf(const Arguments& arguments);

} // namespace app
