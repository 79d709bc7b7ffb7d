/// The options of programs that import models, without what reads them (import_options.h).
#pragma once

#include "common/cli/options.h"

namespace app {

/// --up, --units, --crease-angle, --deflection, --flip-textures, --pose, --memory-limit, --time-limit.
OptionGroup importOptionGroup();

/// Those of the group that state facts about a model: --up and --units.
std::vector<Option> frameOptions();

} // namespace app
