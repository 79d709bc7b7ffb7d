#include "gui/models/example_scenes.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

namespace gui {

namespace {

struct Known {
    const char* folder; ///< and the name of the scene in it
    const char* name;
};
constexpr Known kKnown[]{
    {"nave", QT_TRANSLATE_NOOP("Examples", "Basilica in the sun")},
    {"mirrors", QT_TRANSLATE_NOOP("Examples", "Mirrors and glass")},
    {"organic", QT_TRANSLATE_NOOP("Examples", "Elephants at a pond")},
};

} // namespace

QList<ExampleScene> exampleScenesIn(const QString& folder) {
    QList<ExampleScene> scenes;
    for (const Known& each : kKnown) {
        const QString name = QString::fromLatin1(each.folder);
        const QString path = QStringLiteral("%1/%2/%2.scn").arg(folder, name);
        const QString model = QStringLiteral("%1/%2/generated/%2.glb").arg(folder, name);
        if (QFileInfo(path).isReadable() && QFileInfo(model).isReadable())
            scenes.append({QCoreApplication::translate("Examples", each.name), path});
    }
    return scenes;
}

QStringList sceneFolders() {
    const QDir programs(QCoreApplication::applicationDirPath());
    QStringList folders;
    for (const char* folder : {"../share/rtsuite/scenes", "../../../data"})
        folders.append(QDir::cleanPath(programs.absoluteFilePath(QString::fromLatin1(folder))));
    return folders;
}

QList<ExampleScene> exampleScenes() {
    for (const QString& path : sceneFolders()) {
        if (QList<ExampleScene> scenes = exampleScenesIn(path); !scenes.isEmpty()) return scenes;
    }
    return {};
}

} // namespace gui
