/// The options of programs that import models.
#pragma once

#include "common/command_line.h"
#include "common/options.h"

#include "rtcore/io/import/model_import.h"

namespace app {

/// --crease-angle, --flip-textures, --memory-limit, --time-limit.
OptionGroup importOptionGroup();

/// What they were given, else the importer's defaults.
rtcore::ImportOptions readImportOptions(const Arguments& arguments);

} // namespace app
