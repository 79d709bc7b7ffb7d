#include "gui/models/setting_labels.h"

#include "rtcore/settings/main_settings.h"
#include "rtcore/settings/quality.h"
#include "rtcore/settings/settings_table.h"

#include <QCoreApplication>
#include <QLocale>

namespace gui {

namespace {

using rtcore::Setting;
using rtcore::SettingType;

QString translatedSetting(const QString& text) {
    return QCoreApplication::translate("Settings", text.toUtf8().constData());
}

QString fromView(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

// The text as it is looked up.
QString labelText(std::string_view name) { return QString::fromStdString(rtcore::settingLabel(name)); }

QString number(double value) {
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(value, 'g', QLocale::FloatingPointShortest);
}

QString rangeText(const Setting& setting) {
    if (setting.type != SettingType::Integer && setting.type != SettingType::Number) return {};
    const QString min = number(setting.minimum);
    if (setting.maximum >= rtcore::kUnlimited)
        return QCoreApplication::translate("gui", "at least %1").arg(min);
    return QCoreApplication::translate("gui", "%1 to %2").arg(min, number(setting.maximum));
}

} // namespace

QString settingGroup(std::string_view group) { return translatedSetting(labelText(group)); }
QString settingLabel(std::string_view name) { return translatedSetting(labelText(name)); }
QString settingUnit(std::string_view unit) {
    return unit.empty() ? QString() : translatedSetting(fromView(unit));
}
QString settingHelp(std::string_view help) { return translatedSetting(fromView(help)); }

QString mainSettingLabel(const rtcore::MainSetting& setting) {
    return translatedSetting(fromView(setting.label));
}

QString settingTip(const Setting& setting) {
    QString help = settingHelp(setting.help);
    if (!help.isEmpty()) help[0] = help[0].toUpper();
    const QString range = rangeText(setting);
    const QString usual = QString::fromStdString(rtcore::settingText(setting.defaultValue));
    const QString facts =
        QCoreApplication::translate("gui", "default: %1").arg(settingValueText(setting, usual));
    return QStringLiteral("<qt>%1.<br><code>%2</code>; %3</qt>")
        .arg(help.toHtmlEscaped(), fromView(setting.name),
             range.isEmpty() ? facts : range + QStringLiteral("; ") + facts);
}

QString settingValueText(const Setting& setting, const QString& value) {
    switch (setting.type) {
    case SettingType::Boolean:
        return value == QLatin1String("true") ? QCoreApplication::translate("gui", "on")
                                              : QCoreApplication::translate("gui", "off");
    case SettingType::Choice:
        return settingLabel(value.toStdString());
    case SettingType::Integer:
    case SettingType::Number:
        break;
    }
    if (!setting.zero.empty() && value.toDouble() == 0) return settingLabel(setting.zero);
    const QString shown = number(value.toDouble());
    return setting.unit.empty() ? shown : shown + QLatin1Char(' ') + settingUnit(setting.unit);
}

QStringList settingTexts() {
    QStringList texts;
    for (const Setting& setting : rtcore::settingsTable()) {
        texts << labelText(setting.group) << labelText(setting.name) << fromView(setting.help);
        if (!setting.unit.empty()) texts << fromView(setting.unit);
        if (!setting.zero.empty()) texts << labelText(setting.zero);
        for (const std::string_view choice : setting.choices) texts << labelText(choice);
    }
    for (const rtcore::MainSetting& setting : rtcore::mainSettings()) texts << fromView(setting.label);
    for (const std::string_view quality : rtcore::kQualityNames) texts << labelText(quality);
    texts.removeDuplicates();
    return texts;
}

} // namespace gui
