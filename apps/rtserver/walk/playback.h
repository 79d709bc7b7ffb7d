/// A path of cameras that is shown in real time: a recording, at the pace of which it was made, or a flight.
#pragma once

#include "rtcore/io/text/cam.h"
#include "rtcore/motion/flight_course.h"

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>

namespace rtserver {

/// Reads each .cam file when its time has come; those that a slow server has no time for are passed over.
/// Files without a time follow each other at 30 a second. One thread.
class Playback {
  public:
    struct Shot {
        rtcore::CameraFile camera;
        std::filesystem::path path; ///< for messages
    };

    /// Reads the list and its first camera; cameras are seen from `zero`, that of the scene. Throws
    /// FileError, BadData when the list is empty.
    Playback(const std::filesystem::path& list, const rtcore::LocalOrigin& zero);

    /// A flight from that time on.
    Playback(const rtcore::FlightCourse& course, double from);

    /// Time goes on. The camera that is to be shown now; nothing while that is the one of the last call.
    /// Throws FileError.
    std::optional<Shot> advance(std::chrono::nanoseconds time);
    /// The last camera has been shown for its time.
    bool ended() const;
    std::chrono::nanoseconds untilNext() const;

  private:
    void readNext();

    std::function<Shot(std::size_t)> read_; ///< any of `shots_`
    std::size_t shots_ = 0;
    std::size_t following_ = 0; ///< index of the shot after `next_`
    std::optional<Shot> next_;
    std::chrono::duration<double> now_{0}, due_{0}; ///< since the first camera; when `next_` is to be shown
    std::optional<double> firstTime_;
};

} // namespace rtserver
