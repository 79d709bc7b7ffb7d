#include "renderer/unused_settings.h"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

namespace renderer {

rtcore::Sentence unusedSettingsWarning(const rtcore::RenderSettings& settings,
                                       std::span<const rtcore::SettingAssignment> settingsFile,
                                       std::span<const rtcore::SettingAssignment> commandLine) {
    std::vector<rtcore::SettingAssignment> asked(settingsFile.begin(), settingsFile.end());
    asked.insert(asked.end(), commandLine.begin(), commandLine.end());
    const std::vector<std::string_view> unused = rtcore::unusedSettings(settings, asked);
    if (unused.empty()) return {};
    const std::string integrator = rtcore::settingText(rtcore::getSetting(settings, "integrator"));
    return rtcore::say("integrator {0} does not use {1}", integrator,
                       fmt::format("{}", fmt::join(unused, ", ")));
}

} // namespace renderer
