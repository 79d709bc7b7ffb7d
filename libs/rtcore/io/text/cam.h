/// .cam: one camera, and what else makes one image the same again (docs/formats.md).
#pragma once

#include "rtcore/scene/camera.h"
#include "rtcore/scene/local_origin.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rtcore {

/// Values absent from the file leave those of the scene and of the settings as they are.
struct CameraFile {
    Camera camera;                           ///< nameOffset is 0
    LocalOrigin origin;                      ///< the zero that it is seen from
    std::optional<int> width, height;        ///< pixels
    std::optional<int> antialiasing, bloom;  ///< as the settings `antialiasing` and `bloom.radius`
    std::optional<float> exposure;           ///< the fixed constant c; absent: automatic
    std::optional<std::vector<bool>> lights; ///< version 1: which are on, in the scene's order
    std::vector<int> lightsOn, lightsOff;    ///< ids, each once; the other lights stay as they are
    std::optional<int> environment;          ///< index into the scene's environments
    std::optional<double> time;              ///< seconds since the recording began, >= 0
    friend bool operator==(const CameraFile&, const CameraFile&) = default;
};

/// The camera is seen from `zero`, that of the scene, which is its `origin` then; without one, from the
/// file's own `origin`. Throws FileError: NoInput, or BadData with line and column.
CameraFile readCameraFile(const std::filesystem::path& path, const std::optional<LocalOrigin>& zero = {});
/// The same from memory; `path` is named in errors.
CameraFile parseCameraFile(std::string_view text, const std::filesystem::path& path,
                           const std::optional<LocalOrigin>& zero = {});

/// Replaces the file. Throws FileError CannotWrite, also when a value is one that readCameraFile would
/// refuse.
void writeCameraFile(const std::filesystem::path& path, const CameraFile& file);
std::string formatCameraFile(const CameraFile& file);
/// For people: a camera alone, with its eye in the coordinates of the model's file.
std::string formatCameraInFile(const Camera& camera, const LocalOrigin& zero);

} // namespace rtcore
