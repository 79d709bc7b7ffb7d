/// Settings that were asked for in vain.
#pragma once

#include "rtcore/platform/sentence.h"
#include "rtcore/settings/settings_table.h"

#include <span>

namespace renderer {

/// Names the settings of a .set file and of the command line that the integrator of `settings`
/// does not use; empty where there are none.
rtcore::Sentence unusedSettingsWarning(const rtcore::RenderSettings& settings,
                                       std::span<const rtcore::SettingAssignment> settingsFile,
                                       std::span<const rtcore::SettingAssignment> commandLine);

} // namespace renderer
