#include "bridge/control/setting_value.h"

#include "bridge/control/requests.h"

#include "rtcore/platform/sentence.h"
#include "rtcore/settings/main_settings.h"
#include "rtcore/settings/quality.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace bridge {

namespace {

using nlohmann::json;

const char* typeName(rtcore::SettingType type) {
    switch (type) {
    case rtcore::SettingType::Boolean:
        return "boolean";
    case rtcore::SettingType::Integer:
        return "integer";
    case rtcore::SettingType::Number:
        return "number";
    case rtcore::SettingType::Choice:
        break;
    }
    return "choice";
}

bool isNumber(rtcore::SettingType type) {
    return type == rtcore::SettingType::Integer || type == rtcore::SettingType::Number;
}

json rowJson(const rtcore::Setting& setting, const Limits& limits) {
    json row{{"name", setting.name},
             {"group", setting.group},
             {"type", typeName(setting.type)},
             {"default", settingJson(setting.defaultValue)},
             {"unit", setting.unit},
             {"help", setting.help},
             {"locked", limits.isLocked("edits") || limits.isLocked(setting.name)}};
    if (isNumber(setting.type)) {
        row["min"] = minOf(setting);
        if (maxOf(setting) < rtcore::kUnlimited) row["max"] = maxOf(setting);
        if (!setting.zero.empty()) row["zero"] = setting.zero;
    }
    if (setting.type == rtcore::SettingType::Choice) row["choices"] = setting.choices;
    if (const rtcore::MainSetting* const main = rtcore::findMainSetting(setting.name))
        row["main"] = {{"place", main - rtcore::mainSettings().data() + 1}, {"label", main->label}};
    return row;
}

/// The word that the table reads.
rtcore::SettingValue valueOf(const rtcore::Setting& setting, const json& value) {
    if (value.is_boolean()) return value.get<bool>();
    if (value.is_string()) return value.get<std::string>();
    if (!value.is_number()) throw Refused("a value is a boolean, a number or a text");
    const auto number = value.get<double>();
    constexpr double kMaxInteger = 2147483647;
    if (setting.type == rtcore::SettingType::Integer && number == std::floor(number) &&
        std::abs(number) <= kMaxInteger)
        return static_cast<int>(number);
    return static_cast<float>(number);
}

} // namespace

json settingJson(const rtcore::SettingValue& value) {
    return std::visit([](const auto& each) { return json(each); }, value);
}

json settingsTableJson(const Limits& limits) {
    json rows = json::array();
    for (const rtcore::Setting& setting : rtcore::settingsTable())
        if (setting.browser.offered) rows.push_back(rowJson(setting, limits));
    return rows;
}

json qualitiesJson() {
    json all = json::object();
    for (const std::string_view name : rtcore::kQualityNames) {
        json& values = all[std::string(name)];
        for (const rtcore::SettingAssignment& each : rtcore::settingsOf(*rtcore::qualityNamed(name)))
            if (rtcore::requireSetting(each.name).browser.offered)
                values[each.name] = settingJson(each.value);
    }
    return all;
}

json settingLabelsJson() {
    json labels = json::object();
    const auto add = [&](std::string_view name) { labels[std::string(name)] = rtcore::settingLabel(name); };
    for (const rtcore::Setting& setting : rtcore::settingsTable()) {
        add(setting.name);
        add(setting.group);
        if (!setting.zero.empty()) add(setting.zero);
        for (const std::string_view each : setting.choices) add(each);
    }
    for (const std::string_view each : rtcore::kQualityNames) add(each);
    return labels;
}

std::string settingValueText(const std::string& name, const json& value, const Limits& limits) {
    const rtcore::Setting* const setting = rtcore::findSetting(name);
    if (setting == nullptr || setting->name != name || !setting->browser.offered)
        throw Refused("there is no such setting");
    if (limits.isLocked(setting->name)) throw Refused(rtcore::say("{0} is locked", setting->name));
    try {
        const rtcore::SettingValue checked = rtcore::checkSetting(*setting, valueOf(*setting, value));
        rtcore::checkLive(*setting, checked);
        double number = 0;
        if (const int* whole = std::get_if<int>(&checked)) number = *whole;
        if (const float* real = std::get_if<float>(&checked)) number = static_cast<double>(*real);
        // The caps are decimal numbers, most values floats.
        const auto rounded = [](double bound) { return static_cast<double>(static_cast<float>(bound)); };
        if (isNumber(setting->type) && number > rounded(maxOf(*setting)))
            throw Refused(
                rtcore::say("{0} is {1} at most here", setting->name, fmt::format("{}", maxOf(*setting))));
        if (isNumber(setting->type) && number < rounded(minOf(*setting)))
            throw Refused(
                rtcore::say("{0} is {1} at least here", setting->name, fmt::format("{}", minOf(*setting))));
        return rtcore::settingText(checked);
    } catch (const std::invalid_argument& error) {
        throw Refused(rtcore::sentenceOf(error));
    }
}

} // namespace bridge
