/// The keys of a camera, which .cam has at its root and .scn in [camera].
#pragma once

#include "rtcore/io/text/strict_table.h"
#include "rtcore/io/text/toml_writer.h"
#include "rtcore/scene/camera.h"

namespace rtcore {

/// Asks `table` for eye, forward, lookAt (when `lookAtAllowed`; instead of forward), up and fov. `up` is
/// taken when the key is absent. Calls finish(); every other key must have been asked for before. Throws
/// FileError BadData: eye or forward missing, forward zero, up zero or parallel to forward, fov out of range.
Camera readCamera(StrictTable& table, Vec3 up, bool lookAtAllowed);

void writeCamera(TomlWriter& writer, const Camera& camera);

} // namespace rtcore
