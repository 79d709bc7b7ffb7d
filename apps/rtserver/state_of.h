/// What is shown now, for who asks: the command `state`, and those that tell a part of it.
#pragma once

#include "rtserver/session.h"

#include "common/commands/server_state.h"

#include <string>
#include <vector>

namespace rtserver {

std::string scenePathOf(const Session& session); ///< absolute
std::vector<app::NamedSwitch> lightsOf(const Session& session);
/// One without a name goes by its file.
std::vector<app::NamedSwitch> environmentsOf(const Session& session);

app::ServerState serverStateOf(const Session& session);

} // namespace rtserver
