/// What of the server's commands people in browsers may bring about: a closed list.
#pragma once

#include "common/commands/command_table.h"

namespace bridge {

enum class CommandUse {
    Request,   ///< a page may ask for it, with numbers and words of tables
    Own,       ///< the bridge itself sends it
    Forbidden, ///< files, paths, other people's keys, the server's life
};

/// Of every command of the table; what CUI does itself is Forbidden.
CommandUse commandUse(app::CommandId id);

} // namespace bridge
