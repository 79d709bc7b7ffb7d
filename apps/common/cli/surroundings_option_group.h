/// The options that say what surrounds the model.
#pragma once

#include "common/cli/options.h"

namespace app {

OptionGroup surroundingsOptionGroup();

} // namespace app
