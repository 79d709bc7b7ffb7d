/// The scenes that come with the programs.
#pragma once

#include <QList>
#include <QString>

namespace gui {

struct ExampleScene {
    QString name; ///< for people
    QString path; ///< of the .scn
};

/// Those that are installed beside this program or, where it was built, lie in the sources' `data`; only
/// those whose model is there, too.
QList<ExampleScene> exampleScenes();
/// Those in a folder of scenes.
QList<ExampleScene> exampleScenesIn(const QString& folder);

} // namespace gui
