/// Render settings inside a text file: [live] and [still] of .set and .scn.
#pragma once

#include "rtcore/io/text/strict_table.h"
#include "rtcore/io/text/toml_writer.h"
#include "rtcore/settings/settings_table.h"

#include <span>
#include <string_view>
#include <vector>

namespace rtcore {

/// The assignments of the table `key` in the order of the file; tables within are parts of dotted names, and
/// former names become those of today. Empty when absent. Throws FileError BadData at unknown names, at
/// values that the settings table refuses, in "live" also those that are for stills only, and where a setting
/// stands by its former name as well.
std::vector<SettingAssignment> readSettingsSection(StrictTable& parent, std::string_view key);

/// Nothing when there are no assignments. By the names of today; does not check them.
void writeSettingsSection(TomlWriter& writer, std::string_view key,
                          std::span<const SettingAssignment> assignments);

} // namespace rtcore
