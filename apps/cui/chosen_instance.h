/// Which server the commands go to.
#pragma once

#include "common/cli/command_line.h"

#include <string>

namespace cui {

/// The one that is named; else the one that runs, so that no command goes to another by accident. Throws
/// app::UsageError that lists them where several run.
std::string chosenInstance(const app::Arguments& arguments);

} // namespace cui
