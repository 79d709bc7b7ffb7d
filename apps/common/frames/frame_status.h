/// The status of frames that their servers publish for clients.
#pragma once

#include "ipc/layout/status.h"

#include "rtcore/scene/camera.h"
#include "rtcore/scene/local_origin.h"

namespace app {

/// The part of a status that tells of the size of frames and of the camera that they are seen by.
void setView(const rtcore::Camera& camera, const rtcore::LocalOrigin& origin, int width, int height,
             ipc::Status& status);

} // namespace app
