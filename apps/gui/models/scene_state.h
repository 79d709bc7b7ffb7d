/// What the server says of its settings, lights and environment maps, as the panels show it.
#pragma once

#include <QList>
#include <QMap>
#include <QString>

namespace gui {

struct NamedSwitch {
    bool on = false;
    QString name; ///< may be empty
    friend bool operator==(const NamedSwitch&, const NamedSwitch&) = default;
};

struct SceneState {
    QMap<QString, QString> settings; ///< name to value, both as `settings` writes them
    QList<NamedSwitch> lights;
    QList<NamedSwitch> environments; ///< at most one is on
    friend bool operator==(const SceneState&, const SceneState&) = default;
};

/// Width or height, which follow the window and have no usual value.
bool isPictureSize(const QString& setting);

/// The answer to `settings`; lines of another form are left out.
QMap<QString, QString> readSettings(const QString& answer);
/// The answer to `lights` (on) or `environments` (active): "N STATE [NAME]" a line.
QList<NamedSwitch> readSwitches(const QString& answer);

/// The commands that make `to` of `from`, in the order in which they are to be sent. Lights and environments
/// that only one of them has are left alone.
QStringList commandsBetween(const SceneState& from, const SceneState& to);

} // namespace gui
