/// Reads the options of lightingOptionGroup().
#pragma once

#include "common/cli/command_line.h"

#include "rtcore/io/scene_loader.h"

#include <string_view>

namespace app {

/// The text of --sky. Throws UsageError.
rtcore::Sky readSkyOption(std::string_view text);

/// Throws UsageError, also where both are given.
rtcore::LightingOptions readLightingOptions(const Arguments& arguments);

} // namespace app
