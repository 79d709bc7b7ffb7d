/// Settings that were asked for in vain.
#pragma once

#include "rtcore/settings/settings_table.h"

#include <span>
#include <string>

namespace renderer {

/// A warning that names the settings of a .set file and of the command line that the integrator of `settings`
/// does not use, or "".
std::string unusedSettingsWarning(const rtcore::RenderSettings& settings,
                                  std::span<const rtcore::SettingAssignment> settingsFile,
                                  std::span<const rtcore::SettingAssignment> commandLine);

} // namespace renderer
