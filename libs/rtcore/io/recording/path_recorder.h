/// Records a path through a scene: a .cam file for each frame and the list that names them (docs/formats.md).
#pragma once

#include "rtcore/io/text/cam.h"
#include "rtcore/platform/append_file.h"

#include <filesystem>

namespace rtcore {

/// Everything that add() has returned from is kept, however the process dies: a list at any moment names
/// complete .cam files only. (The machine's own death may take what the system had not written to the disk
/// yet; finish() waits for the list.) add() opens, writes and closes one small file; it never waits for the
/// disk, but a slow network folder makes it slow. For one thread.
class PathRecorder {
  public:
    /// Makes `list` and, beside it, the folder for the .cam files: "walk.cams" for "walk.lst". Throws
    /// FileError CannotWrite; also when one of them exists, since recordings are never overwritten.
    explicit PathRecorder(const std::filesystem::path& list);
    /// Finishes the list if that was not done; ignores failures.
    ~PathRecorder();
    PathRecorder(const PathRecorder&) = delete;
    PathRecorder& operator=(const PathRecorder&) = delete;

    /// The next frame; `frame.time` says when it was. Throws FileError CannotWrite (a full disk, a value that
    /// no .cam may hold); the frame is then not part of the list, and the recording may go on.
    void add(const CameraFile& frame);
    /// Writes the end mark, for programs that follow the list. Nothing may be added any more. Throws
    /// FileError CannotWrite.
    void finish();

    int frames() const { return frames_; } ///< that the list names
    const std::filesystem::path& list() const { return list_; }

  private:
    std::filesystem::path list_, folder_;
    AppendFile lines_;
    int frames_ = 0;
    int number_ = 0; ///< of the last .cam file
    bool finished_ = false;
};

/// The folder in which a recorder puts the .cam files of this list.
std::filesystem::path recordedFolder(const std::filesystem::path& list);

} // namespace rtcore
