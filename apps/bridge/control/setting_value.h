/// A setting's value as pages give and get it.
#pragma once

#include "bridge/control/caps.h"

#include "rtcore/settings/settings_table.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace bridge {

nlohmann::json settingJson(const rtcore::SettingValue& value);
/// The rows for pages.
nlohmann::json settingsTableJson(const Limits& limits);
/// The English labels of settings, groups, choices, words for 0 and qualities, by name.
nlohmann::json settingLabelsJson();
/// The settings of each quality that a page may see, with their values.
nlohmann::json qualitiesJson();
/// The text of a value that may be set. Throws Refused: no such setting, locked, another type, out of range.
std::string settingValueText(const std::string& name, const nlohmann::json& value, const Limits& limits);

} // namespace bridge
