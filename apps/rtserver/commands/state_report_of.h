/// The state that is shown now, for clients that ask: the command `state`, and those that tell a part of it.
#pragma once

#include "rtserver/document/document.h"

#include "common/commands/state_report.h"

#include <cstdint>
#include <string>
#include <vector>

namespace rtserver {

std::string scenePathOf(const Document& document); ///< absolute
std::vector<app::ReportedLight> lightsOf(const Document& document);
/// One without a name goes by its file.
std::vector<app::NamedSwitch> environmentsOf(const Document& document);

app::StateReport stateReportOf(const Document& document, std::uint64_t client = 0);

} // namespace rtserver
