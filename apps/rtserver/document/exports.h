/// The scene and the view that are shown now, as files that show them again.
#pragma once

#include "rtserver/document/document.h"

#include "rtcore/io/text/cam.h"
#include "rtcore/io/text/scn.h"

#include <filesystem>

namespace rtserver {

/// Camera, size, anti-aliasing, bloom, lights, environment, and `exposure` as a fixed one.
rtcore::CameraFile cameraFileOf(const Document& document, float exposure);

/// The scene with its lights and settings as they are now, all of them spelt out. The model is named, not
/// copied.
rtcore::SceneFile sceneFileOf(const Document& document);

/// The same for the scene's own file: its stills keep what they have of their own, but for the settings that
/// are other ones now than the scene was loaded with; so does the image's size.
rtcore::SceneFile savedSceneOf(const Document& document);

} // namespace rtserver
