/// .set: how to render, for the live view and for stills (docs/formats.md).
#pragma once

#include "rtcore/settings/settings_table.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace rtcore {

/// Every name and value is one that the settings table takes. No name stands twice.
struct SettingsFile {
    std::vector<SettingAssignment> live;  ///< [live]: RTServer
    std::vector<SettingAssignment> still; ///< [still]: Renderer
    friend bool operator==(const SettingsFile&, const SettingsFile&) = default;
};

/// Throws FileError: NoInput, or BadData with line and column.
SettingsFile readSettingsFile(const std::filesystem::path& path);
/// The same from memory; `path` is named in errors.
SettingsFile parseSettingsFile(std::string_view text, const std::filesystem::path& path);

/// Replaces the file. Throws FileError CannotWrite, also when a name or value is not in the settings table.
void writeSettingsFile(const std::filesystem::path& path, const SettingsFile& file);
std::string formatSettingsFile(const SettingsFile& file);

} // namespace rtcore
