/// The options of programs that import models, without what reads them (import_options.h).
#pragma once

#include "common/cli/options.h"

namespace app {

/// --crease-angle, --flip-textures, --memory-limit, --time-limit.
OptionGroup importOptionGroup();

/// Of those, what the user says of a model: --up and --units.
std::vector<Option> frameOptions();

} // namespace app
