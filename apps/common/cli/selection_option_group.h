/// The options that say which parts of the model are seen and which lights are on.
#pragma once

#include "common/cli/options.h"

namespace app {

OptionGroup selectionOptionGroup();

} // namespace app
