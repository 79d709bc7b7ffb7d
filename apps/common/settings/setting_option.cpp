#include "common/settings/setting_option.h"

#include "common/cli/command_line.h"
#include "common/settings/setting_suggestions.h"

#include <stdexcept>

namespace app {

rtcore::SettingAssignment settingOf(const std::string& option, const std::string& name,
                                    const std::string& value) {
    try {
        const rtcore::Setting& setting = rtcore::requireSetting(name);
        return {std::string(setting.name), rtcore::parseSetting(setting, value)};
    } catch (const std::invalid_argument& error) {
        throw UsageError("option '--" + option + "': " + error.what());
    }
}

rtcore::SettingAssignment settingOf(const std::string& nameAndValue) {
    const std::size_t equals = nameAndValue.find('=');
    if (equals == std::string::npos || equals == 0) {
        throw UsageError(
            "option '--setting' takes NAME=VALUE, such as maxDepth=8; 'Renderer --settings' lists the names");
    }
    return settingOf("setting", nameAndValue.substr(0, equals), nameAndValue.substr(equals + 1));
}

std::vector<std::string> suggestAssignments(std::span<const std::string> words) {
    const std::string& begun = words.back();
    const std::size_t equals = begun.find('=');
    std::vector<std::string> all;
    if (equals == std::string::npos) {
        for (const std::string& name : settingNames()) all.push_back(name + "=");
    } else {
        const std::string name = begun.substr(0, equals);
        for (const std::string& value : settingValues(name)) all.push_back(name + "=" + value);
    }
    return all;
}

} // namespace app
