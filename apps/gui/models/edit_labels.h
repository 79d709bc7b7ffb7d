/// What the steps are called that undo takes back.
#pragma once

#include "common/commands/command_table.h"

#include <QString>

namespace gui {

/// As menus say it: "Bloom radius" for the server's "set bloom.radius"; "" for "".
QString editLabel(const QString& step);
/// Of a command that edits; of `set`, which the setting names, and of others: "".
QString editText(app::CommandId command);

} // namespace gui
