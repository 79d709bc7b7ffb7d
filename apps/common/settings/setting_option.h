/// Settings that options of the command line assign.
#pragma once

#include "rtcore/settings/settings_table.h"

#include <span>
#include <string>
#include <vector>

namespace app {

/// The setting `name`, to which the option --`option` gives `value`. Throws UsageError for an unknown name or
/// a value that the table of settings refuses.
rtcore::SettingAssignment settingOf(const std::string& option, const std::string& name,
                                    const std::string& value);

/// NAME=VALUE, as --setting takes it. Throws UsageError as above.
rtcore::SettingAssignment settingOf(const std::string& nameAndValue);

/// NAME=VALUE, for completion: names until there is a "=", then values.
std::vector<std::string> suggestAssignments(std::span<const std::string> words);

} // namespace app
