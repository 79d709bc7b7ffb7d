/// What the server says of its scene, settings, lights, environment maps and edits, as the panels show it.
#pragma once

#include <QList>
#include <QMap>
#include <QString>

#include <optional>

namespace gui {

struct NamedSwitch {
    bool on = false;
    QString name; ///< may be empty
    friend bool operator==(const NamedSwitch&, const NamedSwitch&) = default;
};

struct SceneState {
    QString up;                      ///< "+y"
    float metresPerUnit = 1;         ///< above 0
    QMap<QString, QString> settings; ///< name to value, both as `settings` writes them
    QList<NamedSwitch> lights;
    QList<NamedSwitch> environments; ///< at most one is on
    QString undo, redo;              ///< the steps that these would make (editLabel()); empty: none
    int edits = 0;                   ///< made and not taken back
    friend bool operator==(const SceneState&, const SceneState&) = default;
};

/// Width or height, which follow the window and have no usual value.
bool isPictureSize(const QString& setting);

/// What the server says of what it shows.
struct StateAnswer {
    QString scene; ///< absolute path
    SceneState state;
};

/// The answer to the command `state`; nothing when it is none.
std::optional<StateAnswer> readState(const QString& answer);

} // namespace gui
