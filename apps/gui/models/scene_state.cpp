#include "gui/models/scene_state.h"

#include <QStringList>

#include <algorithm>

namespace gui {

bool isPictureSize(const QString& setting) {
    return setting == QLatin1String("width") || setting == QLatin1String("height");
}

QMap<QString, QString> readSettings(const QString& answer) {
    QMap<QString, QString> settings;
    for (const QString& line : answer.split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
        const qsizetype sign = line.indexOf(QLatin1String(" = "));
        if (sign > 0) settings.insert(line.left(sign), line.mid(sign + 3));
    }
    return settings;
}

QList<NamedSwitch> readSwitches(const QString& answer) {
    QList<NamedSwitch> switches;
    for (const QString& line : answer.split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
        const QString state = line.section(QLatin1Char(' '), 1, 1);
        const bool on = state == QLatin1String("on") || state == QLatin1String("active");
        switches.append({on, line.section(QLatin1Char(' '), 2)});
    }
    return switches;
}

QStringList commandsBetween(const SceneState& from, const SceneState& to) {
    QStringList commands;
    for (auto setting = to.settings.begin(); setting != to.settings.end(); ++setting) {
        if (from.settings.value(setting.key()) != setting.value())
            commands.append(QStringLiteral("set %1 %2").arg(setting.key(), setting.value()));
    }
    for (qsizetype i = 0; i < std::min(from.lights.size(), to.lights.size()); ++i) {
        if (from.lights[i].on != to.lights[i].on)
            commands.append(QStringLiteral("light %1 %2")
                                .arg(i + 1)
                                .arg(to.lights[i].on ? QLatin1String("on") : QLatin1String("off")));
    }
    for (qsizetype i = 0; i < std::min(from.environments.size(), to.environments.size()); ++i) {
        if (to.environments[i].on && !from.environments[i].on)
            commands.append(QStringLiteral("environment %1").arg(i + 1));
    }
    return commands;
}

} // namespace gui
