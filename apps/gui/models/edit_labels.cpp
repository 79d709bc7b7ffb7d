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
    case app::CommandId::LightAdd:
        return text(QT_TRANSLATE_NOOP("Edits", "add light"));
    case app::CommandId::LightCopy:
        return text(QT_TRANSLATE_NOOP("Edits", "copy light"));
    case app::CommandId::LightRemove:
        return text(QT_TRANSLATE_NOOP("Edits", "remove light"));
    case app::CommandId::LightMove:
        return text(QT_TRANSLATE_NOOP("Edits", "move light"));
    case app::CommandId::LightAim:
        return text(QT_TRANSLATE_NOOP("Edits", "turn light"));
    case app::CommandId::LightColour:
        return text(QT_TRANSLATE_NOOP("Edits", "colour of light"));
    case app::CommandId::LightTemperature:
        return text(QT_TRANSLATE_NOOP("Edits", "temperature of light"));
    case app::CommandId::LightPower:
        return text(QT_TRANSLATE_NOOP("Edits", "power of light"));
    case app::CommandId::LightKind:
        return text(QT_TRANSLATE_NOOP("Edits", "kind of light"));
    case app::CommandId::LightSize:
        return text(QT_TRANSLATE_NOOP("Edits", "size of light"));
    case app::CommandId::LightAngles:
        return text(QT_TRANSLATE_NOOP("Edits", "angles of light"));
    case app::CommandId::LightMirrored:
        return text(QT_TRANSLATE_NOOP("Edits", "light in mirrors"));
    case app::CommandId::LightName:
        return text(QT_TRANSLATE_NOOP("Edits", "name of light"));
    case app::CommandId::Light:
        return text(QT_TRANSLATE_NOOP("Edits", "light"));
    case app::CommandId::Environment:
    case app::CommandId::EnvironmentOpen:
    case app::CommandId::EnvironmentNone:
    case app::CommandId::EnvironmentRotation:
    case app::CommandId::EnvironmentStrength:
        return text(QT_TRANSLATE_NOOP("Edits", "environment"));
    case app::CommandId::Sky:
    case app::CommandId::SkyHour:
    case app::CommandId::SkyDate:
    case app::CommandId::SkyPlace:
    case app::CommandId::SkyNorth:
    case app::CommandId::SkyDirection:
    case app::CommandId::SkyTurbidity:
    case app::CommandId::SkyStrength:
    case app::CommandId::SkyGround:
    case app::CommandId::SkyHaze:
        return text(QT_TRANSLATE_NOOP("Edits", "sky"));
    case app::CommandId::Look:
        return text(QT_TRANSLATE_NOOP("Edits", "light of the scene"));
    case app::CommandId::MaterialSet:
    case app::CommandId::MaterialReset:
        return text(QT_TRANSLATE_NOOP("Edits", "material"));
    case app::CommandId::PartHide:
    case app::CommandId::PartShow:
    case app::CommandId::PartIsolate:
    case app::CommandId::PartShowAll:
        return text(QT_TRANSLATE_NOOP("Edits", "visible parts"));
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
    case app::CommandId::BookmarkAdd:
    case app::CommandId::BookmarkGo:
    case app::CommandId::BookmarkRename:
    case app::CommandId::BookmarkRemove:
        return text(QT_TRANSLATE_NOOP("Edits", "bookmark"));
    case app::CommandId::LoadCamera:
        return text(QT_TRANSLATE_NOOP("Edits", "camera"));
    case app::CommandId::LoadSet:
        return text(QT_TRANSLATE_NOOP("Edits", "settings"));
    case app::CommandId::Focus:
        return text(QT_TRANSLATE_NOOP("Edits", "focus there"));
    case app::CommandId::CameraSet:
    case app::CommandId::CameraOrthographic:
    case app::CommandId::CameraLookAt:
    case app::CommandId::CameraFit:
    case app::CommandId::CameraView:
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
