/// Settings that options of the command line assign.
#pragma once

#include "rtcore/settings/settings_table.h"

#include <string>

namespace app {

/// The setting `name`, to which the option --`option` gives `value`. Throws UsageError for an unknown name or
/// a value that the table of settings refuses.
rtcore::SettingAssignment settingOf(const std::string& option, const std::string& name,
                                    const std::string& value);

/// NAME=VALUE, as --setting takes it. Throws UsageError as above.
rtcore::SettingAssignment settingOf(const std::string& nameAndValue);

} // namespace app
