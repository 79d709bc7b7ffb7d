/// Environment maps from image files of any format that image_file.h reads; 8- and 16-bit ones are decoded
/// from sRGB. Negative values become 0. The name of the result is the (first) file's name without folder and
/// extension. All throw FileError: NoInput, or BadData when the content is damaged or its shape is not the
/// expected one.
#pragma once

#include "rtcore/scene/environment.h"
#include "rtcore/scene/environment_source.h"

#include <array>
#include <filesystem>

namespace rtcore {

/// Full sphere, width = 2 height.
Environment loadEquirectangular(const std::filesystem::path& path);

/// A cross of squares, 4 x 3 (left to right -X +Z +X -Z, with +Y above and -Y below +Z) or 3 x 4 (the same,
/// with -Z below -Y and turned by half a turn, so that the cross folds up).
Environment loadCubeCross(const std::filesystem::path& path);

/// Six squares in a row or a column, in the order +X -X +Y -Y +Z -Z.
Environment loadCubeStrip(const std::filesystem::path& path);

/// Six files of one square each, in the order +X -X +Y -Y +Z -Z.
Environment loadCubeFaces(const std::array<std::filesystem::path, 6>& paths);

/// As its kind says, which is one with files; neither its intensity nor its rotation is applied.
Environment loadEnvironment(const EnvironmentFile& file);

struct OpenedEnvironment {
    EnvironmentFile file;
    Environment environment;
};
/// One file whose kind its shape tells: a sphere, a cross or a strip.
OpenedEnvironment openEnvironment(const std::filesystem::path& path);

} // namespace rtcore
