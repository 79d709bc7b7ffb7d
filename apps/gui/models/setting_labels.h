/// Texts for the settings in the window. A setting that is added to the core gets its texts by itself, in
/// English until translations/tables_cs.ts has them.
#pragma once

#include <QString>
#include <QStringList>

#include <string_view>

namespace rtcore {
struct MainSetting;
struct Setting;
} // namespace rtcore

namespace gui {

/// A group of the table (Setting::group) as it is called: "Ambient occlusion"; the one without a name:
/// "Image".
QString settingGroup(std::string_view group);
/// The part behind the dot, or all of it: "brighterSeconds" is "Brighter seconds". For choices, too.
QString settingLabel(std::string_view name);
/// As it is called outside of its group.
QString mainSettingLabel(const rtcore::MainSetting& setting);
QString settingUnit(std::string_view unit);
QString settingHelp(std::string_view help);
/// Help, name, range and default, in rich text.
QString settingTip(const rtcore::Setting& setting);
/// A value as it is shown: with the unit, or a choice by its label.
QString settingValueText(const rtcore::Setting& setting, const QString& value);

/// All that is translated of the table of settings, in English; the context is "Settings".
QStringList settingTexts();

} // namespace gui
