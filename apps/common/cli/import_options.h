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

/// The values of importOptionGroup()'s options; the importer's defaults for those that are not given.
rtcore::ImportOptions readImportOptions(const Arguments& arguments);

} // namespace app
