#include "renderer/unused_settings.h"

#include <fmt/format.h>

#include <string_view>
#include <vector>

namespace renderer {

std::string unusedSettingsWarning(const rtcore::RenderSettings& settings,
                                  std::span<const rtcore::SettingAssignment> settingsFile,
                                  std::span<const rtcore::SettingAssignment> commandLine) {
    std::vector<rtcore::SettingAssignment> asked(settingsFile.begin(), settingsFile.end());
    asked.insert(asked.end(), commandLine.begin(), commandLine.end());
    const std::vector<std::string_view> unused = rtcore::unusedSettings(settings, asked);
    if (unused.empty()) return "";
    return fmt::format("warning: integrator {} does not use {}",
                       rtcore::settingText(rtcore::getSetting(settings, "integrator")),
                       fmt::join(unused, ", "));
}

} // namespace renderer
