/// Video lists: the .cam files of a film, one a line (docs/formats.md).
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rtcore {

/// The first line of a list that a program writes frame by frame. The last line of such a list counts only
/// when its line end is there, so that it is valid whenever its writer died.
inline constexpr std::string_view kRecordingMark = "# recording";
/// Its last line once it is complete.
inline constexpr std::string_view kEndMark = "# end";

/// The paths in their order, joined to the folder of the list. May be empty. The files are not looked at.
/// Throws FileError: NoInput, or BadData with line and column when the text is not UTF-8 or holds a zero
/// byte.
std::vector<std::filesystem::path> readCameraList(const std::filesystem::path& path);
/// The same from memory; `path` gives the folder and is named in errors.
std::vector<std::filesystem::path> parseCameraList(std::string_view text, const std::filesystem::path& path);

/// A list that may still be written: lines without their line end do not count yet.
struct GrowingCameraList {
    std::vector<std::filesystem::path> cameras;
    bool ended = false; ///< its last line that is not blank is the end mark
};
/// Throws as readCameraList does, but a list that is not there yet is empty.
GrowingCameraList readGrowingCameraList(const std::filesystem::path& path);
GrowingCameraList parseGrowingCameraList(std::string_view text, const std::filesystem::path& path);

/// The line of a list at `list` that names `camera`, with its line end. Throws as writeCameraList does.
std::string cameraListLine(const std::filesystem::path& list, const std::filesystem::path& camera);

/// Replaces the list. Paths below its folder are written relative to it, others absolute.
/// Throws FileError CannotWrite, also for a path that a list cannot hold (white space at its ends or before a
/// '#', a line break, no UTF-8).
void writeCameraList(const std::filesystem::path& path, std::span<const std::filesystem::path> cameras);

} // namespace rtcore
