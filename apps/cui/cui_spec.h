/// CUI's command line as data: its options, and the commands of the common table
/// (common/commands/command_table.h).
#pragma once

#include "common/cli/options.h"

namespace cui {

const app::ProgramSpec& cuiSpec();

} // namespace cui
