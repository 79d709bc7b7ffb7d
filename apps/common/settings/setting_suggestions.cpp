#include "common/settings/setting_suggestions.h"

#include "rtcore/settings/settings_table.h"

namespace app {

std::vector<std::string> settingNames() {
    std::vector<std::string> names;
    for (const rtcore::Setting& setting : rtcore::settingsTable()) names.emplace_back(setting.name);
    return names;
}

std::vector<std::string> settingValues(const std::string& name) {
    const rtcore::Setting* setting = rtcore::findSetting(name);
    if (setting == nullptr) return {};
    if (setting->type == rtcore::SettingType::Boolean) return {"on", "off"};
    return {setting->choices.begin(), setting->choices.end()};
}

} // namespace app
