/// Flights as lists of cameras, which every program reads.
#pragma once

#include "common/flights/film_exposure.h"

#include "rtcore/io/text/cam.h"
#include "rtcore/motion/flight_course.h"

#include <atomic>
#include <filesystem>
#include <optional>

namespace app {

/// As many as a list of cameras has room for.
inline constexpr int kMaxFilmFrames = 500'000;

/// FlightCourse::frames(). Throws rtcore::BadValue where these are more than kMaxFilmFrames.
int filmFrames(const rtcore::FlightCourse& course, double perSecond);

/// A film of a flight.
struct FilmOfFlight {
    rtcore::FlightCourse course;
    double perSecond = 25;
    /// What its cameras have in common; of `camera` and `time` nothing counts. Its exposure is that of views
    /// without one.
    rtcore::CameraFile common = {};
    /// That of views where `common` has none, either; absent: each image finds its own.
    std::optional<FilmExposure> exposure = {};
};

/// A frame, counted from 0, with its time.
rtcore::CameraFile flightCamera(const FilmOfFlight& film, int frame);

/// Writes the list and, beside it, its .cam files (PathRecorder). Throws what that and filmFrames() do, and
/// FileError Stopped when the process is to end or `stop` is set: what is written until then is removed.
/// `stop` may be null.
void recordFlight(const std::filesystem::path& list, const FilmOfFlight& film,
                  const std::atomic<bool>* stop = nullptr);

} // namespace app
