/// The options of programs that import models.
#pragma once

#include "common/cli/command_line.h"
#include "common/cli/import_option_group.h"

#include "rtcore/io/import/model_import.h"

#include <optional>
#include <string>

namespace app {

/// Metres per unit; nothing for "auto". Throws UsageError.
std::optional<double> readUnits(const std::string& text);

/// What the options of importOptionGroup() were given, else the importer's defaults.
rtcore::ImportOptions readImportOptions(const Arguments& arguments);

} // namespace app
