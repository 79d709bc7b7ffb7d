#include "renderer/settings_list.h"

#include "rtcore/settings/settings_table.h"

namespace renderer {

std::string settingsList() {
    std::string text;
    for (const rtcore::Setting& setting : rtcore::settingsTable()) {
        text.append(setting.name).append(" = ").append(rtcore::settingText(setting.defaultValue));
        text.append("\n    ").append(setting.help).append("\n    ").append(rtcore::settingRange(setting));
        if (!setting.unit.empty()) text.append(" (").append(setting.unit).append(")");
        text += "\n";
    }
    return text;
}

} // namespace renderer
