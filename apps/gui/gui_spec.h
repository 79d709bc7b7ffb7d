/// The window's command line, as data. Needs no Qt, so that its manual can be made without.
#pragma once

#include "common/cli/command_line.h"
#include "common/cli/options.h"

#include <string>
#include <vector>

namespace gui {

const app::ProgramSpec& guiSpec();

struct Options {
    std::string file;     ///< absolute; empty = none
    std::string instance; ///< empty: as the preferences say
    bool connect = false;
    std::vector<std::string> server; ///< options of the server that is started, as RTServer takes them
};

/// Throws app::UsageError.
Options readOptions(const app::Arguments& arguments);
/// Throws rtcore::FileError (NoInput) when there is no such file.
void requireFile(const Options& options);

} // namespace gui
