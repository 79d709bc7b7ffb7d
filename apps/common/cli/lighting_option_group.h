/// The options that say what surrounds the model.
#pragma once

#include "common/cli/options.h"

namespace app {

OptionGroup lightingOptionGroup();

} // namespace app
