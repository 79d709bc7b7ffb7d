/// What is shown now, for clients that ask: the command `state`, and those that tell a part of it.
#pragma once

#include "rtserver/document.h"

#include "common/commands/state_report.h"

#include <cstdint>
#include <string>
#include <vector>

namespace rtserver {

std::string scenePathOf(const ServerState& state); ///< absolute
std::vector<app::ReportedLight> lightsOf(const ServerState& state);
/// One without a name goes by its file.
std::vector<app::NamedSwitch> environmentsOf(const ServerState& state);

app::StateReport stateReportOf(const ServerState& state, std::uint64_t client = 0);

} // namespace rtserver
