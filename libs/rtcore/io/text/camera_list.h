/// Video lists: the .cam files of a film, one a line (docs/formats.md).
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rtcore {

/// The paths in their order, joined to the folder of the list. May be empty. The files are not looked at.
/// Throws FileError: NoInput, or BadData with line and column when the text is not UTF-8 or holds a zero
/// byte.
std::vector<std::filesystem::path> readCameraList(const std::filesystem::path& path);
/// The same from memory; `path` gives the folder and is named in errors.
std::vector<std::filesystem::path> parseCameraList(std::string_view text, const std::filesystem::path& path);

/// Replaces the list. Paths below its folder are written relative to it, others absolute.
/// Throws FileError CannotWrite, also for a path that a list cannot hold (white space at its ends or before a
/// '#', a line break, no UTF-8).
void writeCameraList(const std::filesystem::path& path, std::span<const std::filesystem::path> cameras);

} // namespace rtcore
