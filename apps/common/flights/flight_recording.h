/// Flights as lists of cameras, which every program reads.
#pragma once

#include "rtcore/io/text/cam.h"
#include "rtcore/motion/flight_course.h"

#include <filesystem>

namespace app {

/// A frame of a film of it, counted from 0; with its time. `zero`: that of the scene.
rtcore::CameraFile flightCamera(const rtcore::FlightCourse& course, int frame, double perSecond,
                                const rtcore::LocalOrigin& zero);

/// Writes the list and, beside it, its .cam files (PathRecorder). Throws what that does, and FileError
/// Stopped when the process is to end: what is written until then is removed.
void recordFlight(const std::filesystem::path& list, const rtcore::FlightCourse& course, double perSecond,
                  const rtcore::LocalOrigin& zero);

} // namespace app
