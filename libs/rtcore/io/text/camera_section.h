/// The keys of a camera, which .cam has at its root and .scn in [camera].
#pragma once

#include "rtcore/io/text/strict_table.h"
#include "rtcore/io/text/toml_writer.h"
#include "rtcore/scene/camera.h"

#include <array>

namespace rtcore {

inline constexpr std::array kCameraKeys{"eye", "forward",           "lookAt", "up",
                                        "fov", "orthographicWidth", "aspect"};

/// Asks `table` for these keys, for lookAt (instead of forward) when `lookAtAllowed`; orthographicWidth
/// instead of fov makes the camera orthographic. `up` is taken when the key is absent, or what upwardsOf()
/// has in its place where the camera looks straight along it. Calls finish(); every other key must have been
/// asked for before. Throws FileError BadData: eye or forward missing, forward zero, up zero, or given and
/// parallel to forward, numbers out of range, fov and orthographicWidth both.
Camera readCamera(StrictTable& table, Vec3 up, bool lookAtAllowed);

/// Its eye in the coordinates in which that of the scene's zero is `zero`.
void writeCamera(TomlWriter& writer, const Camera& camera, const LocalOrigin& zero = {});

} // namespace rtcore
