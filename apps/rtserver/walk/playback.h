/// A recorded path that is shown again, at the pace at which it was recorded.
#pragma once

#include "rtcore/io/text/cam.h"

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

namespace rtserver {

/// Reads each .cam file when its time has come; those that a slow server has no time for are passed over.
/// Files without a time follow each other at 30 a second. One thread.
class Playback {
  public:
    /// Reads the list and its first camera; cameras are seen from `zero`, that of the scene. Throws
    /// FileError, BadData when the list is empty.
    Playback(const std::filesystem::path& list, const rtcore::LocalOrigin& zero);

    /// Time goes on. The camera that is to be shown now, with the path of its file; nothing while that is the
    /// one of the last call. Throws FileError.
    struct Shot {
        rtcore::CameraFile camera;
        std::filesystem::path path;
    };
    std::optional<Shot> advance(std::chrono::nanoseconds time);
    /// The last camera has been shown for its time.
    bool ended() const;
    std::chrono::nanoseconds untilNext() const;

  private:
    void readNext();

    std::vector<std::filesystem::path> files_;
    rtcore::LocalOrigin zero_;
    std::size_t following_ = 0; ///< index of the file after `next_`
    std::optional<Shot> next_;
    std::chrono::duration<double> now_{0}, due_{0}; ///< since the first camera; when `next_` is to be shown
    std::optional<double> firstTime_;
};

} // namespace rtserver
