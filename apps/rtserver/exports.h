/// What is shown now, as files that show it again.
#pragma once

#include "rtserver/session.h"

#include "rtcore/io/text/cam.h"
#include "rtcore/io/text/scn.h"

#include <filesystem>

namespace rtserver {

/// Camera, size, anti-aliasing, bloom, lights, environment, and `exposure` as a fixed one.
rtcore::CameraFile cameraFileOf(const Session& session, float exposure);

/// The scene with its lights and settings as they are now, all of them spelt out. The model is named, not
/// copied.
rtcore::SceneFile sceneFileOf(const Session& session);

} // namespace rtserver
