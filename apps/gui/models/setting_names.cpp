#include "gui/models/setting_names.h"

#include <QCoreApplication>

namespace gui {

namespace {

// For translators; whatever is not here is shown as it is derived from the table of settings.
[[maybe_unused]] constexpr const char* kKnown[] = {
    QT_TRANSLATE_NOOP("Settings", "Picture"),
    QT_TRANSLATE_NOOP("Settings", "Width"),
    QT_TRANSLATE_NOOP("Settings", "Height"),
    QT_TRANSLATE_NOOP("Settings", "Antialiasing"),
    QT_TRANSLATE_NOOP("Settings", "Shadows"),
    QT_TRANSLATE_NOOP("Settings", "Reflections"),
    QT_TRANSLATE_NOOP("Settings", "Refractions"),
    QT_TRANSLATE_NOOP("Settings", "Textures"),
    QT_TRANSLATE_NOOP("Settings", "Max depth"),
    QT_TRANSLATE_NOOP("Settings", "Min contribution"),
    QT_TRANSLATE_NOOP("Settings", "Ambient occlusion"),
    QT_TRANSLATE_NOOP("Settings", "On"),
    QT_TRANSLATE_NOOP("Settings", "Samples"),
    QT_TRANSLATE_NOOP("Settings", "Distance"),
    QT_TRANSLATE_NOOP("Settings", "Bloom"),
    QT_TRANSLATE_NOOP("Settings", "Exposure"),
    QT_TRANSLATE_NOOP("Settings", "Mode"),
    QT_TRANSLATE_NOOP("Settings", "Value"),
    QT_TRANSLATE_NOOP("Settings", "Key"),
    QT_TRANSLATE_NOOP("Settings", "Tone mapping"),
    QT_TRANSLATE_NOOP("Settings", "Dithering"),
    QT_TRANSLATE_NOOP("Settings", "Environment filter"),
    QT_TRANSLATE_NOOP("Settings", "pixels"),
    QT_TRANSLATE_NOOP("Settings", "bounces"),
    QT_TRANSLATE_NOOP("Settings", "rays"),
    QT_TRANSLATE_NOOP("Settings", "scene units"),
    QT_TRANSLATE_NOOP("Settings", "radiance"),
};

QString translated(const QString& text) {
    return QCoreApplication::translate("Settings", text.toUtf8().constData());
}

QString fromView(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

// "maxDepth": "Max depth".
QString words(const QString& name) {
    QString text;
    for (const QChar letter : name) {
        if (letter.isUpper() && !text.isEmpty()) text += QLatin1Char(' ');
        text += text.isEmpty() ? letter.toUpper() : letter.toLower();
    }
    return text;
}

} // namespace

QString settingGroup(std::string_view name) {
    const std::size_t dot = name.find('.');
    return translated(dot == std::string_view::npos ? QStringLiteral("Picture")
                                                    : words(fromView(name.substr(0, dot))));
}

QString settingLabel(std::string_view name) {
    const std::size_t dot = name.rfind('.');
    return translated(words(fromView(dot == std::string_view::npos ? name : name.substr(dot + 1))));
}

QString settingUnit(std::string_view unit) { return unit.empty() ? QString() : translated(fromView(unit)); }
QString settingHelp(std::string_view help) { return translated(fromView(help)); }

} // namespace gui
