/// Keys that edit what is shown: each runs the command that does the same.
#pragma once

#include "rtserver/commands/commands.h"
#include "rtserver/messages.h"
#include "rtserver/walk/workspace.h"

#include "rtcore/motion/key_bindings.h"

namespace rtserver {

/// The same step of `undo` as by the command, and a message that says what became of it: a light or an
/// environment that the scene lacks is a message, too, and no error. Nothing for keys that move.
void editByKey(const rtcore::ActionTap& tap, Workspace& state, Host& host, Messages& messages);

} // namespace rtserver
