#include "gui/models/edit_labels.h"

#include "gui/models/setting_labels.h"

#include "common/commands/command_lookup.h"
#include "common/commands/quoting.h"

#include <QCoreApplication>

#include <exception>
#include <string>
#include <vector>

namespace gui {

QString editText(app::CommandId id) {
    const auto text = [](const char* english) { return QCoreApplication::translate("Edits", english); };
    switch (id) {
    case app::CommandId::Defaults:
        return text(QT_TRANSLATE_NOOP("Edits", "defaults"));
    case app::CommandId::Bloom:
        return text(QT_TRANSLATE_NOOP("Edits", "bloom"));
    case app::CommandId::Light:
        return text(QT_TRANSLATE_NOOP("Edits", "light"));
    case app::CommandId::Environment:
        return text(QT_TRANSLATE_NOOP("Edits", "environment"));
    case app::CommandId::CameraReset:
        return text(QT_TRANSLATE_NOOP("Edits", "reset camera"));
    case app::CommandId::CameraPaste:
        return text(QT_TRANSLATE_NOOP("Edits", "paste camera"));
    case app::CommandId::CameraAngle:
    case app::CommandId::CameraLens:
    case app::CommandId::CameraZoom:
        return text(QT_TRANSLATE_NOOP("Edits", "field of view"));
    case app::CommandId::Up:
        return text(QT_TRANSLATE_NOOP("Edits", "up axis"));
    case app::CommandId::Units:
        return text(QT_TRANSLATE_NOOP("Edits", "unit"));
    case app::CommandId::LoadCamera:
        return text(QT_TRANSLATE_NOOP("Edits", "camera"));
    case app::CommandId::LoadSet:
        return text(QT_TRANSLATE_NOOP("Edits", "settings"));
    case app::CommandId::Focus:
        return text(QT_TRANSLATE_NOOP("Edits", "focus there"));
    case app::CommandId::CameraSet:
    case app::CommandId::CameraOrthographic:
    case app::CommandId::CameraLookAt:
    case app::CommandId::CameraTurn:
        return text(QT_TRANSLATE_NOOP("Edits", "look there"));
    default:
        return {};
    }
}

QString editLabel(const QString& step) {
    if (step.isEmpty()) return {};
    try {
        const std::vector<std::string> words = app::splitWords(step.toStdString());
        const app::FoundCommand found = app::findCommand(words);
        const bool named = found.words < words.size();
        if (found.command->id == app::CommandId::Set && named) return settingLabel(words[found.words]);
        const QString text = editText(found.command->id);
        if (text.isEmpty()) return step;
        return named ? text + QLatin1Char(' ') + QString::fromStdString(words[found.words]) : text;
    } catch (const std::exception&) {
        return step; // of a newer server
    }
}

} // namespace gui
