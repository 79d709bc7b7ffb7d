/// The speed of MD5 animations, which Assimp 5.2.5 misses where no blank line stands before it.
#pragma once

#include <filesystem>
#include <optional>

namespace rtcore {

/// Frames per second of the .md5anim beside a .md5mesh; nothing where there is none, or it does not say.
/// Throws as readTextFile() does.
std::optional<double> md5FrameRate(const std::filesystem::path& mesh);

} // namespace rtcore
