/// The environment maps that come with the programs.
#pragma once

#include <QList>
#include <QString>

namespace gui {

struct InstalledSky {
    QString name; ///< for people
    QString path;
};

/// Those that are installed beside this program or, where it was built, lie in the sources' `data`.
QList<InstalledSky> installedSkies();
/// Those in a folder of scenes.
QList<InstalledSky> installedSkiesIn(const QString& folder);

/// Whether a file with such a name is an environment map, and neither model nor scene.
bool isEnvironmentFile(const QString& path);

} // namespace gui
