/// The scenes that come with the programs.
#pragma once

#include <QList>
#include <QString>
#include <QStringList>

namespace gui {

struct ExampleScene {
    QString name; ///< for people
    QString path; ///< of the .scn
};

/// Where scenes may lie: beside the installed program, and in the sources where it was built.
QStringList sceneFolders();
/// Those that are installed beside this program or, where it was built, lie in the sources' `data`; only
/// those whose model is there, too.
QList<ExampleScene> exampleScenes();
/// Those in a folder of scenes.
QList<ExampleScene> exampleScenesIn(const QString& folder);

} // namespace gui
