/// What the server says of its scene, settings, lights, environment maps and camera, as the panels show it.
#pragma once

#include "rtcore/io/text/cam.h"
#include "rtcore/scene/camera.h"

#include <QList>
#include <QMap>
#include <QString>

#include <optional>
#include <string>
#include <vector>

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

/// The scene's state and where the camera is, both at one moment.
struct Placement {
    QString scene; ///< absolute path
    rtcore::Camera camera;
    SceneState state;
};

/// The answer to the command `state`; nothing when it is none.
std::optional<Placement> readPlacement(const QString& answer);

/// What a .cam file's text says; nothing when it is none.
std::optional<rtcore::CameraFile> readCameraText(const QString& text);
/// `state` with what such a file brings with it. Lights and environments that the scene has not are left out.
SceneState withCameraFile(SceneState state, const rtcore::CameraFile& file);

/// The command that makes the server look through it.
std::string cameraCommand(const rtcore::Camera& camera);
/// The commands that make `to` of `from`, in the order in which they are to be sent. Lights and environments
/// that only one of them has are left alone.
std::vector<std::string> commandsBetween(const SceneState& from, const SceneState& to);

} // namespace gui
